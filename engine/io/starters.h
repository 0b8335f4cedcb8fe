// Tables to begin with, as `pinfield new` and the editor's File > New offer them: small, played as they are, and worth reading.
#pragma once
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/reflect/catalog.h"

namespace pinfield {

struct Starter {
    std::string_view key;  ///< "classic"
    std::string_view title, doc;
    std::string_view text;
};

/// The first is what is meant when nobody chooses.
std::span<const Starter> starters();

/// The line that tells text editors where the JSON Schema of a table is: a path from the table's folder, or an address.
std::string modeline(std::string_view schema);

/// A starter's text under a name of its own, with the modeline on top. Fails when no text can say that name (one that is no UTF-8).
Result<std::string> new_table(const Starter& starter, const std::string& name, std::string_view schema, std::shared_ptr<const Catalog> catalog);

}  // namespace pinfield

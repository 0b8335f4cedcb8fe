// What names mean where an expression or a $name is read: the table's params, a template's arguments, a copy's number.
#pragma once
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "engine/expression/expression.h"

namespace pinfield {

struct NamedValue {
    enum class Kind : unsigned char { number, text, broken };  ///< broken: what it is has been found wrong, and said
    Kind kind = Kind::number;
    double value = 0;
    Measure measure{};
    std::string text{};
};

/// The names of one place, before those of the places around it.
class Names {
public:
    explicit Names(const Names* outer = nullptr) : outer_(outer) {}

    void set(const std::string& name, NamedValue value) { own_.insert_or_assign(name, std::move(value)); }
    /// The innermost meaning, which then counts as used; null: there is none.
    const NamedValue* find(std::string_view name) const;
    bool is_used(const std::string& name) const { return used_.contains(name); }
    /// Those that mean something here and are of this kind, for a suggestion.
    std::vector<std::string_view> all(NamedValue::Kind kind) const;

private:
    const Names* outer_;
    std::map<std::string, NamedValue, std::less<>> own_;
    mutable std::set<std::string, std::less<>> used_;
};

}  // namespace pinfield

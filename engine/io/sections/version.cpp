// pinfield: 1
#include <fmt/format.h>

#include "engine/io/section.h"

namespace pinfield::sections {
namespace {

void read(ReadContext& context, Scene&, const YamlNode&, const YamlNode& value) {
    if (value.kind == YamlKind::scalar && value.text == "1") return;
    context.report(Code::unknown_version, value.span,
                   value.kind == YamlKind::scalar ? fmt::format("version {} of the format is not known", value.text)
                                                  : "the version of the format is due here",
                   "this program reads version 1; a table of a later one needs a later program");
}

}  // namespace

extern const Section version{
    .key = "pinfield",
    .read = read,
    .write = [](const Scene&) { return std::string("pinfield: 1\n"); },
    .schema = [] { return std::string(R"({"description": "Version of the format.", "const": 1})"); },
};

}  // namespace pinfield::sections

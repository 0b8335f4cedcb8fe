// Every section of a table: described whole, and told apart by its own comparison alone.
#include "engine/io/section.h"

#include <catch2/catch.hpp>
#include <map>

#include "engine/io/same_content.h"
#include "engine/io/write_table.h"
#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

struct Variants {
    const char *one, *other;  ///< two values of the section
};

const std::map<std::string_view, Variants>& variants() {
    static const std::map<std::string_view, Variants> all{
        {"table", {"{name: Moon, slope: 6}", "{name: Moon, slope: 7}"}},
        {"physics", {"{step: 1ms}", "{step: 2ms}"}},
        {"materials", {"{rubber: {restitution: 0.8}}", "{rubber: {restitution: 0.7}}"}},
        {"params", {"{gap: 4cm}", "{gap: {value: 4cm, min: 1cm}}"}},
        {"templates", {"{gear: {args: {r: 1cm}, nodes: [circle: {radius: r}]}}", "{gear: {args: {r: 2cm}, nodes: [circle: {radius: r}]}}"}},
        {"include", {"[a.yaml]", "[b.yaml]"}},
        {"scene", {"[union: {id: u, children: [circle: {radius: 3cm}]}]", "[union: {id: u, children: [circle: {radius: 4cm}]}]"}},
        {"inputs", {"{left: Z}", "{left: [Z, A]}"}},
        {"tests", {"[{run: 1s, expect: u.hits >= 1}]", "[{run: 1s, expect: u.hits >= 2}]"}},
    };
    return all;
}

/// A table with each section's first value, but for `changed`, which has its other.
std::string table_with(std::string_view changed) {
    std::string text = "pinfield: 1\n";
    for (const auto& [key, values] : variants()) text += std::string(key) + ": " + (key == changed ? values.other : values.one) + "\n";
    return text;
}

Reading read_beside(const std::string& text) { return read_with(text, {{"a.yaml", "pinfield: 1"}, {"b.yaml", "pinfield: 1"}}); }

}  // namespace

TEST_CASE("every section that is read is written, described and compared, and every other says why it is not") {
    for (const Section* section : all_sections()) {
        INFO(section->key);
        CHECK(find_section(section->key) == section);
        const bool has_code = section->unsupported != Code{};
        CHECK(has_code == (section->read == nullptr && section->read_all == nullptr));
        CHECK((section->write == nullptr) == has_code);
        CHECK((section->schema == nullptr) == has_code);
        const bool says_something = !has_code && section->key != "pinfield";
        CHECK((section->same == nullptr) != says_something);
        CHECK(variants().count(section->key) == (says_something ? 1 : 0));
    }
}

TEST_CASE("a change in one section is seen by its comparison and by no other's, and comes back from canonical text") {
    const Reading one = read_beside(table_with(""));
    INFO(told(one));
    REQUIRE(one.ok());
    CHECK(same_content(one.scene, read_beside(table_with("")).scene));
    for (const auto& [changed, values] : variants()) {
        INFO(changed);
        const Reading other = read_beside(table_with(changed));
        REQUIRE(other.ok());
        CHECK_FALSE(same_content(one.scene, other.scene));
        for (const Section* section : all_sections())
            if (section->same) CHECK(section->same(one.scene, other.scene) == (section->key != changed));
        const std::string canonical = write_table(other.scene);
        CHECK(find_section(changed)->same(read_beside(canonical).scene, other.scene));
        CHECK(write_table(read_beside(canonical).scene) == canonical);
    }
}

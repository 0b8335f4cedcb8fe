// Files that mean harm, made here because nobody wants them in a repository: each is answered with a code and a place,
// in less than a second of one processor and 256 MB, in a process of its own.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <sstream>

#include "engine/io/write_table.h"
#include "tests/io/support.h"

using namespace pinfield;
using namespace pinfield::test;

namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr double most_seconds = 10;
constexpr long most_kilobytes = 4 << 20;  // a sanitizer's own memory is not ours to judge
#elif !defined(__OPTIMIZE__)
constexpr double most_seconds = 3;
constexpr long most_kilobytes = 256 << 10;
#else
constexpr double most_seconds = 1;
constexpr long most_kilobytes = 256 << 10;
#endif

struct Answer {
    std::string first;  ///< "E0203 4:15", or "fine"
    double seconds = 0;
    long kilobytes = 0;
};

double seconds_of(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

/// Reads the text in a child process and tells what that cost.
Answer answer_to(const std::string& text) {
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        const Reading result = read(text);
        std::string first = result.diagnostics.empty() ? "fine" : codes_and_places(result).front();
        first += "\n" + told(result).substr(0, 1000);
        const bool sent = write(ends[1], first.data(), first.size()) == static_cast<ssize_t>(first.size());
        _exit(sent ? 0 : 1);
    }
    close(ends[1]);
    std::string all;
    char buffer[4096];
    for (ssize_t count; (count = ::read(ends[0], buffer, sizeof buffer)) > 0;)
        all.append(buffer, static_cast<std::size_t>(count));
    close(ends[0]);
    int status = 0;
    rusage usage{};
    REQUIRE(wait4(child, &status, 0, &usage) == child);
    INFO(all);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
    return {all.substr(0, all.find('\n')), seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime), usage.ru_maxrss};
}

std::string repeated(std::string_view piece, std::size_t count) {
    std::string out;
    out.reserve(piece.size() * count);
    for (std::size_t i = 0; i < count; ++i) out += piece;
    return out;
}

/// before0after before1after ...
std::string numbered(std::string_view before, std::string_view after, int count) {
    std::string out;
    for (int i = 0; i < count; ++i) out.append(before).append(std::to_string(i)).append(after);
    return out;
}

struct Hostile {
    const char* name;
    std::string text;
    const char* answer;
};

std::vector<Hostile> hostile_files() {
    const std::string head = "pinfield: 1\nscene:\n";
    std::string bomb = "a: &a [x, x, x, x, x, x, x, x, x, x]\n";
    for (char c = 'b'; c <= 'j'; ++c) {
        const char before[] = {'*', static_cast<char>(c - 1), ',', ' ', '\0'};
        bomb.append(1, c).append(": &").append(1, c).append(" [").append(repeated(before, 10)).append("]\n");
    }
    std::string ladder = "- &x0 " + repeated("[", 50) + repeated("]", 50) + "\n";
    ladder += "- &x1 " + repeated("[", 30) + "*x0" + repeated("]", 30) + "\n";
    return {
        {"an empty file", "", "E0101 1:1"},
        {"blanks only", repeated(" \n", 100000), "E0101 1:1"},
        {"a cyclic alias of 14 bytes", "&a [*a, &b *a]", "E0113 1:5"},
        {"an alias bomb", bomb, "E0114 6:8"},
        {"aliases that nest too deep together", ladder, "E0114 2:37"},
        {"100 000 open brackets", repeated("[", 100000), "E0107 1:1025"},
        {"2 000 000 open braces", repeated("{", 2000000), "E0107 1:1025"},
        {"100 000 levels of lists", repeated("- ", 100000), "E0107 1:129"},
        {"1900 levels of maps",
         [] {
             std::string out;
             for (std::size_t i = 0; i < 1900; ++i) out += std::string(i, ' ') + "a:\n";
             return out;
         }(),
         "E0107 65:65"},
        {"3 MiB", head + repeated("# padding\n", 314573), "E0106 1:1"},
        {"2 MB in one word", "a: " + std::string(2000000, 'x'), "E0109 1:4"},
        {"1.8 MB in one folded text", "a: b\n" + repeated(" b\n", 600000), "E0109 1:1"},
        {"300 kB in one folded text", "a: b\n" + repeated(" b\n", 100000), "E0109 1:4"},
        {"a quote that runs to the end", "a: \"" + std::string(2000000, '\n'), "E0109 1:4"},
        {"a short quote that runs to the end", "a: \"" + std::string(700000, '\n'), "E0105 1:4"},
        {"more than 150 000 events", "a: [" + repeated("1,", 200000) + "]", "E0108 1:300002"},
        {"more than 150 000 events without a comma", "a:\n" + repeated("- 1\n", 200000), "E0108 150000:1"},
        {"a NUL byte", std::string("pinfield: 1\nta\0ble: {}\n", 23), "E0103 2:3"},
        {"the byte that a YAML parser takes for the end", "pinfield: 1\n\x04junk: {}\n", "E0103 2:1"},
        {"lone carriage returns", "pinfield: 1\rscene: []\r", "E0103 1:12"},
        {"bad UTF-8", "pinfield: 1\ntable: {name: \xC3\x28}\n", "E0102 2:15"},
        {"an overlong slash", "pinfield: 1\ntable: {name: \xC0\xAF}\n", "E0102 2:15"},
        {"a surrogate", "pinfield: 1\ntable: {name: \xED\xA0\x80}\n", "E0102 2:15"},
        {"UTF-16", std::string("\xFF\xFEp\0i\0", 6), "E0102 1:1"},
        {"30 001 nodes", head + repeated("- circle:\n", 30001), "E0110 30003:3"},
        {"30 001 of the largest nodes", head + repeated("- flipper:\n", 30001), "E0110 30003:3"},
        {"5000 points", head + "- polygon: {points: [" + repeated("[0, 0], ", 5000) + "]}\n", "E0111 3:21"},
        {"271 820 nodes", head + repeated("  - circle: {radius: 1mm}\n", 271820), "E0106 1:1"},
        {"70 000 nodes", head + repeated("  - circle: {radius: 1mm}\n", 70000), "E0108 30002:11"},
        {"29 000 nodes with an unknown field", head + repeated("- circle: {radus: 1}\n", 29000), "E0202 3:12"},
        {"28 000 nodes in one line with an error at its end",
         "pinfield: 1\nscene: [" + repeated("circle: {radius: 1mm}, ", 28000) + "circle: {radus: 1mm}]\n",
         "E0202 2:644018"},
        {"100 000 errors in one line", "pinfield: 1\nscene: [circle: {at: [" + repeated("a b,", 100000) + "]}]\n",
         "E0201 2:22"},
        {"50 000 unknown keys", head + "- circle:\n" + numbered("    k", ": 1\n", 50000), "E0202 4:5"},
        {"70 000 unknown sections", "pinfield: 1\n" + numbered("foo", ": 1\n", 70000), "E0202 2:1"},
        {"70 000 anchors", numbered("- &a", " x\n", 70000), "E0201 1:1"},
        {"70 000 keys that are lists", repeated("? []\n", 70000), "E0121 1:3"},
        {"100 000 materials", "pinfield: 1\nmaterials:\n" + numbered("  m", ": {}\n", 100000), "E0108 75001:9"},
        {"14 000 unknown materials beside 20 000 known ones",
         "pinfield: 1\nmaterials:\n" + numbered("  m", ": {}\n", 20000) + "scene:\n" +
             numbered("- circle: {material: n", "}\n", 14000),
         "E0301 20004:22"},
        {"90 000 unknown inputs beside 20 000 known ones",
         "pinfield: 1\ninputs:\n" + numbered("  i", ": A\n", 20000) + "scene:\n- flipper: {input: [" +
             numbered("j", ", ", 90000) + "]}\n",
         "E0302 20004:20"},
        {"20 000 unknown keys of a keyboard", "pinfield: 1\ninputs:\n" + numbered("  i", ": Ax\n", 20000), "W0502 3:7"},
        {"12 000 expectations of 20 000 nodes without a name, and a wrong one",
         head + repeated("- circle:\n", 20000) + "tests:\n- expect:\n" +
             numbered("  - 'circle[", "].hits >= 0'\n", 12000) + "  - circel.hits > 0\n",
         "E0304 32005:5"},
        {"20 000 nodes of one name", head + repeated("- circle: {id: a}\n", 20000), "E0303 4:16"},
        {"a megabyte of key", "? " + repeated("a", 60000) + "\n: 1\n", "E0204 1:1"},
        {"an exponent beyond all", head + "- circle: {radius: 1e" + repeated("9", 1000) + "}\n", "E0210 3:20"},
    };
}

}  // namespace

TEST_CASE("every hostile file is answered with code and place within a second and 256 MB") {
    for (const Hostile& file : hostile_files()) {
        Answer answer = answer_to(file.text);
        // The fastest of three: other programs slow a processor down, none speeds it up.
        for (int i = 0; i < 2 && answer.seconds > most_seconds; ++i) answer = answer_to(file.text);
        INFO(file.name << ": " << answer.seconds << " s, " << answer.kilobytes << " kB");
        CHECK(answer.first == file.answer);
        CHECK(answer.seconds < most_seconds);
        CHECK(answer.kilobytes < most_kilobytes);
    }
}

TEST_CASE("a table at its limits still reads") {
    const std::string head = "pinfield: 1\nscene:\n";
    CHECK(read(head + repeated("- circle:\n", 20000)).ok());
    CHECK(read("\xEF\xBB\xBF" + head + "- circle: {}\r\n").ok());
    CHECK(read(head + "- group: {note: '" + std::string(60000, 'x') + "'}\n").ok());
}

TEST_CASE("no mutation of a table crashes or hangs the reader, and what still reads can be written and read again") {
    CounterRng rng(2024);
    constexpr std::string_view special = "{}[]:,#&*!|>'\"%@`-? \n\t~<=.0123456789eE+_()$";
    int still_good = 0;
    for (const auto& [name, original] : good_tables()) {
        for (int i = 0; i < 150; ++i) {
            std::string text = original;
            const auto count = 1 + rng.next_u64() % 4;
            for (std::uint64_t k = 0; k < count && !text.empty(); ++k) {
                const std::size_t at = rng.next_u64() % text.size();
                switch (rng.next_u64() % 5) {
                    case 0: text[at] = static_cast<char>(rng.next_u64()); break;
                    case 1: text[at] = special[rng.next_u64() % special.size()]; break;
                    case 2: text.erase(at, 1 + rng.next_u64() % 8); break;
                    case 3: text.insert(at, 1, special[rng.next_u64() % special.size()]); break;
                    default: text.insert(at, text.substr(rng.next_u64() % text.size(), rng.next_u64() % 40));
                }
            }
            const Reading result = read(text);
            for (const Diagnostic& d : result.diagnostics) {
                REQUIRE(d.where.file == main_file);
                REQUIRE(d.where.span.begin <= d.where.span.end);
                REQUIRE(d.where.span.end <= text.size());
            }
            if (!result.ok()) continue;
            ++still_good;
            INFO(text << write_table(result.scene));
            REQUIRE(read(write_table(result.scene)).ok());
        }
    }
    CHECK(still_good > 50);
}

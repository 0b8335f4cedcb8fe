#include <catch2/catch.hpp>

#include <string>

#include "engine/core/at.h"

#include "engine/core/diagnostic.h"

using namespace pinfield;

namespace {

/// The message for one byte of a text of one line.
std::string shown(const std::string& line, std::size_t byte) {
    const Sources sources(SourceText("t.yaml", line + "\n"));
    return format({"E0000", Severity::error, "what", sources.main().place({byte, byte + 1}), ""}, sources);
}

/// The character of the shown line that stands over the caret.
std::string over_caret(const std::string& message) {
    const std::size_t line = message.find('\n') + 1, carets = message.find('\n', line) + 1;
    std::size_t byte = line;
    for (std::size_t column = message.find('^') - carets; column > 0; --column)
        do ++byte;
        while ((static_cast<unsigned char>(message[byte]) & 0xc0u) == 0x80u);
    std::size_t end = byte + 1;
    while ((static_cast<unsigned char>(message[end]) & 0xc0u) == 0x80u) ++end;
    return message.substr(byte, end - byte);
}

}  // namespace

TEST_CASE("the caret stands under the character that is meant, in long lines and after characters of several bytes too") {
    std::string line;
    for (int i = 0; i < 3000; ++i) line += i % 7 == 0 ? "\u00e4" : i % 5 == 0 ? "\u20ac" : std::string(1, static_cast<char>('a' + i % 26));
    for (const int length : {1, 2, 150, 199, 200, 201, 1000, 3000}) {
        std::size_t bytes = 0;
        std::vector<std::size_t> starts;
        for (; static_cast<int>(starts.size()) < length; ++bytes)
            if ((static_cast<unsigned char>(line[bytes]) & 0xc0u) != 0x80u) starts.push_back(bytes);
        while ((static_cast<unsigned char>(line[bytes]) & 0xc0u) == 0x80u) ++bytes;
        const std::string text = line.substr(0, bytes);
        for (const int character : {0, 1, length / 3, length / 2, length - 2, length - 1}) {
            if (character < 0 || character >= length) continue;
            const std::size_t begin = at(starts, character);
            const std::size_t end = character + 1 < length ? starts[static_cast<std::size_t>(character) + 1] : text.size();
            const std::string message = shown(text, begin);
            INFO(length << " characters, the one at " << character << ":\n" << message);
            CHECK(over_caret(message) == text.substr(begin, end - begin));
            CHECK(message.find(":1:" + std::to_string(character + 1) + ": ") != std::string::npos);
            CHECK(message.size() < 1000);
        }
    }
}

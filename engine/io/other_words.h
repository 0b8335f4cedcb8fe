// What people write who know another program: the word that Pinfield has for it.
#pragma once
#include <string_view>

namespace pinfield {

/// What to write where a node is due; empty for words that mean nothing here.
std::string_view other_word_for_node(std::string_view word);
/// What to write where a field of a node is due.
std::string_view other_word_for_field(std::string_view word);

}  // namespace pinfield

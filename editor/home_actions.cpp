// Where a value is written that a template, a copy or an expression gives.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "editor/edit_tools.h"
#include "editor/handlers.h"

namespace pinfield::editor {
namespace {

constexpr std::size_t most_homes = 6;

const Node* selected_maker(const AppState& state) {
    const Scene& scene = state.document.scene();
    const Node* node = scene.find(state.selection.primary());
    return node && !node->is_record() ? maker_of(scene, node->id) : nullptr;
}

void write_out(AppState& state) {
    const NodeId maker = selected_maker(state)->id;
    const std::string label = fmt::format("Write out {}", state.document.scene().path(maker));
    const auto why = state.document.write_out(maker, label);
    say(state, why.value_or(label), why.has_value());
    if (!why) select(state, maker);
}

template <std::size_t n>
bool has_home(const AppState& state) { return state.home && state.home->homes.size() > n; }

template <std::size_t n>
void answer(AppState& state) {
    const HomeQuestion question = *std::exchange(state.home, std::nullopt);
    const std::string label = change_label(state.document.scene(), question.edit.node, question.edit.field);
    const ValueHome& home = question.homes[n];
    if (const auto why = state.document.edit_home(question.edit, home, label)) return say(state, *why, true);
    say(state, fmt::format("{}: {}", label, home.told));
}

}  // namespace

void ask_for_home(AppState& state) {
    auto question = state.document.take_home_question();
    if (!question || asks(state)) return;
    // The nearest are kept, and the last one: writing it out.
    std::vector<ValueHome>& homes = question->homes;
    if (homes.size() > most_homes) homes.erase(homes.begin() + static_cast<std::ptrdiff_t>(most_homes) - 2, homes.end() - 2);
    state.home = std::move(question);
    say(state, {});  // the question says it
}

std::span<const Handler> home_handlers() {
    static const Handler handlers[] = {
        {"home.1", has_home<0>, answer<0>},
        {"home.2", has_home<1>, answer<1>},
        {"home.3", has_home<2>, answer<2>},
        {"home.4", has_home<3>, answer<3>},
        {"home.5", has_home<4>, answer<4>},
        {"home.6", has_home<5>, answer<5>},
        {"home.cancel", has_home<0>, [](AppState& s) { s.home.reset(); }},
        {"edit.write_out", [](const AppState& s) { return !s.document.previewing() && selected_maker(s); }, write_out},
        {"edit.ask_homes", [](const AppState& s) { return s.document.remembers_homes(); },
         [](AppState& s) {
             s.document.forget_homes();
             say(s, "The next value that stands elsewhere is asked about");
         }},
    };
    return handlers;
}

}  // namespace pinfield::editor

#include "editor/app_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <utility>

#include "editor/edit_tools.h"
#include "editor/handlers.h"
#include "editor/handles.h"
#include "editor/keep_work.h"
#include "editor/lay_under.h"
#include "editor/pick.h"
#include "editor/starters.h"
#include "engine/core/at.h"
#include "engine/core/keys.h"
#include "engine/core/shown.h"
#include "engine/scene/validate.h"

namespace pinfield::editor {
namespace {

const std::shared_ptr<const SourceText>& text_of(const AppState& state) { return state.document.scene().sources.shared_main(); }

std::string name_of(const std::string& path) { return shown(path.substr(path.find_last_of('/') + 1)); }

std::string name_of(const Document& document) { return document.path().empty() ? "the new table" : name_of(document.path()); }

void tell_of_moved_balls(AppState& state) {
    const std::vector<NodeId>& left = state.session.left();
    if (left.empty()) return;
    const std::string what = state.document.scene().path(left.front());
    say(state, left.size() == 1 ? fmt::format("Moved a ball out of {}", what) : fmt::format("Moved {} balls out of {}", left.size(), what));
}

void replace_document(AppState& state, Document document) {
    Session session(document);
    session.play(state.session.playing());
    session.set_slow_motion(state.session.slow_motion());
    document.take_changes();
    state.aids_folder.keep(state.document.path(), state.aids);
    state.aids = state.aids_folder.open(document.path());
    state.document = std::move(document);
    state.session = std::move(session);
    state.selection = {};
    state.entered = {};
    state.source = {};
    state.disk = DiskState::same;
    state.merge.reset();
    state.merge_put_off.clear();
    state.shared.reset();
    state.home.reset();
    run(state, "view.all");
}

bool open_now(AppState& state, const std::string& path) {
    Result<Document> document = Document::open(path, state.catalog);
    if (!document) return say(state, document.error().message, true), false;
    replace_document(state, std::move(*document));
    state.recent.add(state.document.path());
    if (has_errors(state.document.diagnostics())) say(state, fmt::format("{} has problems", name_of(state.document)), true);
    else say(state, fmt::format("Opened {}", name_of(state.document)));
    offer_work(state);
    return true;
}

/// Goes on with what a prompt held up; unsaved work has been dealt with.
void go_on(AppState& state, const Prompt& prompt) {
    if (prompt.then_action == "app.quit") {
        state.quit = true;
        if (state.keeper) state.keeper->drop();
    } else if (prompt.then_action.starts_with("new.")) {
        for (const Starter& starter : starters())
            if (action_of(starter) == prompt.then_action) replace_document(state, Document::untitled(state.catalog, starter.text));
        state.choosing = false;
        say(state, "A new table");
    } else if (prompt.path.empty()) ask_path(state, "file.open");
    else open_now(state, prompt.path);
}

/// Goes on at once, or asks first when unsaved work would be lost.
void guard(AppState& state, std::string then_action, std::string path = {}) {
    state.document.cancel_preview();
    const bool pending = state.source.pending();
    const char* what = pending ? "has text in the source panel that does not read yet" : "has unsaved changes";
    Prompt prompt{fmt::format("{} {}.", name_of(state.document), what), std::move(then_action), std::move(path)};
    if (state.document.dirty() || pending) state.prompt = std::move(prompt);
    else go_on(state, prompt);
}

void say_saved(AppState& state) {
    state.recent.add(state.document.path());
    const bool pending = state.source.pending();
    say(state, fmt::format("Saved {}{}", name_of(state.document), pending ? ", but not the text that does not read yet" : ""), pending);
}

bool save_now(AppState& state) {
    if (!state.document.previewing()) look_at_disk(state);  // what others have saved meanwhile goes in, not under
    if (state.merge) return say(state, fmt::format("Not saved: {} changed on disk too", name_of(state.document)), true), false;
    keep_safe(state);  // whoever dies between the save and the end of the journal leaves both with the same text
    const Result<void> saved = state.document.save();
    if (saved) say_saved(state);
    else say(state, saved.error().message, true);
    return saved.has_value();
}

void save(AppState& state) {
    if (state.document.path().empty()) ask_path(state, "file.save_as");
    else save_now(state);
}

void answer_save(AppState& state) {
    const Prompt prompt = *std::exchange(state.prompt, std::nullopt);
    if (state.document.path().empty()) {
        ask_path(state, "file.save_as");
        state.after_dialog = prompt;
    } else if (save_now(state) && !state.source.pending()) go_on(state, prompt);  // that text is in no file
}

void answer_discard(AppState& state) { go_on(state, *std::exchange(state.prompt, std::nullopt)); }

void close_dialog(AppState& state) {
    state.dialog_action.clear();
    state.replaces.clear();
    state.after_dialog.reset();
}

void accept_path(AppState& state) {
    if (state.dialog_path.empty()) return say(state, "Type a path first", true);
    if (state.dialog_action == "file.open") {
        if (open_now(state, state.dialog_path)) close_dialog(state);
        return;
    }
    if (state.dialog_action == "underlay.open") {
        if (lay_under(state, state.dialog_path)) close_dialog(state);
        return;
    }
    std::error_code unknown;
    const bool there = std::filesystem::exists(state.dialog_path, unknown);
    if (there && !std::filesystem::equivalent(state.dialog_path, state.document.path(), unknown) &&
        std::exchange(state.replaces, state.dialog_path) != state.dialog_path)
        return say(state, fmt::format("There is a {} already. Save again to replace it, or give another name.", name_of(state.dialog_path)),
                   true);
    keep_safe(state);
    const Result<void> saved = state.document.save_as(state.dialog_path);
    if (!saved) return say(state, saved.error().message, true);
    say_saved(state);
    const std::optional<Prompt> next = state.after_dialog;
    close_dialog(state);
    if (next && !state.source.pending()) go_on(state, *next);
}

void reload(AppState& state) {
    const Result<void> reloaded = state.document.reload();
    if (!reloaded) return say(state, reloaded.error().message, true);
    state.merge.reset();
    state.disk = DiskState::same;
    say(state, fmt::format("Reloaded {}", name_of(state.document)));
}

void undo(AppState& state) {
    const std::string what = state.document.previewing() ? "Cancelled" : fmt::format("Undone: {}", *state.document.undo_label());
    state.document.undo();
    say(state, what);
}

void redo(AppState& state) {
    const std::string what = fmt::format("Redone: {}", *state.document.redo_label());
    state.document.redo();
    say(state, what);
}

void deselect(AppState& state) {
    if (state.document.previewing()) state.document.cancel_preview();
    else if (state.show_help) state.show_help = false;
    else if (state.entered) select(state, state.entered);  // out of it, one level
    else state.selection = {};
}

void frame_selection(AppState& state) {
    Box2 box;
    for (const NodeId node : state.selection.nodes()) box = box.merged(bounds_of(state, node));
    if (!state.selection.empty()) state.view.frame(box.grown(0.02));
    else run(state, "view.all");
}

bool has_prompt(const AppState& s) { return s.prompt.has_value(); }
bool has_recovery(const AppState& s) { return s.recovery.has_value(); }
bool has_shared(const AppState& s) { return s.shared.has_value(); }

void answer_shared(AppState& state, SharedAnswer answer) {
    const SharedEdit edit = *std::exchange(state.shared, std::nullopt);
    if (const auto why = state.document.edit_shared(edit, answer)) say(state, *why, true);
    else say(state, fmt::format("{} {}", edit.label, answer == SharedAnswer::here ? "here only" : "everywhere"));
}

bool has_draft(const AppState& s) { return s.source.pending(); }
bool has_dialog(const AppState& s) { return !s.dialog_action.empty(); }

constexpr Handler handlers[] = {
    {"file.new", always, [](AppState& s) { s.choosing = true; }},
    {"new.classic", always, [](AppState& s) { guard(s, "new.classic"); }},
    {"new.fan", always, [](AppState& s) { guard(s, "new.fan"); }},
    {"new.homework", always, [](AppState& s) { guard(s, "new.homework"); }},
    {"new.blank", always, [](AppState& s) { guard(s, "new.blank"); }},
    {"new.cancel", [](const AppState& s) { return s.choosing; }, [](AppState& s) { s.choosing = false; }},
    {"file.open", always, [](AppState& s) { guard(s, "file.open"); }},
    {"file.save", [](const AppState& s) { return s.document.path().empty() || s.document.dirty() || s.source.pending(); }, save},
    {"file.save_as", always, [](AppState& s) { ask_path(s, "file.save_as"); }},
    {"file.reload", [](const AppState& s) { return !s.document.path().empty(); }, reload},
    {"app.quit", always, [](AppState& s) { guard(s, "app.quit"); }},
    {"edit.undo", [](const AppState& s) { return s.document.can_undo() || s.document.previewing(); }, undo},
    {"edit.redo", [](const AppState& s) { return s.document.can_redo() && !s.document.previewing(); }, redo},
    {"edit.deselect", always, deselect},
    {"select.find", always, [](AppState& s) { s.find_node = s.show_panels = true; }},
    {"edit.type", has_selection, [](AppState& s) { s.type_value = s.show_panels = true; }},
    {"view.menus", always, [](AppState& s) { s.open_menus = s.show_panels = true; }},
    {"edit.source", always, [](AppState& s) { s.preferences.show_source = s.type_source = true; }},
    {"edit.lists", always, [](AppState& s) { s.show_lists = true; }},
    {"lists.close", [](const AppState& s) { return s.show_lists; }, [](AppState& s) { s.show_lists = false; }},
    {"play.toggle", always, [](AppState& s) { s.session.play(!s.session.playing()); }},
    {"play.pause", [](const AppState& s) { return s.session.playing(); }, [](AppState& s) { s.session.play(false); }},
    {"play.step", always, [](AppState& s) { s.session.single_step(); }},
    {"play.reset", always, [](AppState& s) { s.session.reset(); }},
    {"play.slower", [](const AppState& s) { return s.session.slow_motion() < slowest; },
     [](AppState& s) { s.session.set_slow_motion(2 * s.session.slow_motion()); }},
    {"play.faster", [](const AppState& s) { return s.session.slow_motion() > 1; },
     [](AppState& s) { s.session.set_slow_motion(s.session.slow_motion() / 2); }},
    {"view.frame", always, frame_selection},
    {"view.all", always, [](AppState& s) { s.view.frame_table({{0, 0}, s.session.program().size}); }},
    {"view.zoom_in", always, [](AppState& s) { s.view.zoom_at(s.view.origin + 0.5 * s.view.size, 1.25); }},
    {"view.zoom_out", always, [](AppState& s) { s.view.zoom_at(s.view.origin + 0.5 * s.view.size, 0.8); }},
    {"view.command_palette", always, [](AppState& s) { s.show_command_palette = !s.show_command_palette; }},
    {"help.keys", always, [](AppState& s) { s.show_help = !s.show_help; }},
    {"prompt.save", has_prompt, answer_save},
    {"prompt.discard", has_prompt, answer_discard},
    {"prompt.cancel", has_prompt, [](AppState& s) { s.prompt.reset(); }},
    {"shared.everywhere", has_shared, [](AppState& s) { answer_shared(s, SharedAnswer::everywhere); }},
    {"shared.here", has_shared, [](AppState& s) { answer_shared(s, SharedAnswer::here); }},
    {"shared.cancel", has_shared, [](AppState& s) { s.shared.reset(); }},
    {"recover.restore", has_recovery, restore_work},
    {"recover.discard", has_recovery, discard_work},
    {"recover.later", has_recovery, put_work_off},
    {"source.try_again", has_draft, [](AppState& s) { s.source.try_again(s.document); }},
    {"source.discard", has_draft, [](AppState& s) { s.source.discard(); }},
    {"dialog.accept", has_dialog, accept_path},
    {"dialog.cancel", has_dialog, close_dialog},
};

const Handler& handler_of(std::string_view action) {
    for (const std::span<const Handler> list : {std::span<const Handler>(handlers), edit_handlers(), arrange_handlers(), merge_handlers(),
                                                preference_handlers(), underlay_handlers(), home_handlers()})
        for (const Handler& handler : list)
            if (handler.action == action) return handler;
    assert(false && "every action of the table has a handler");
    return handlers[0];
}

bool is_bound(const InputBinding& input, std::string_view key) {
    return std::any_of(input.keys.begin(), input.keys.end(), [&](const std::string& name) { return key_code(name) == key_code(key); });
}

/// While a question is open, only its answers count.
bool blocked(const AppState& state, std::string_view action) {
    if (state.prompt) return !action.starts_with("prompt.");
    if (has_dialog(state)) return !action.starts_with("dialog.");
    if (state.shared) return !action.starts_with("shared.");
    if (state.home) return !action.starts_with("home.");
    if (state.merge) return !action.starts_with("merge.");
    if (state.choosing) return !action.starts_with("new.");
    // Closing the window puts the offer off; the window frames its table, whatever it asks.
    if (state.recovery) return !action.starts_with("recover.") && !action.starts_with("view.") && action != "app.quit";
    return false;
}

}  // namespace

AppState::AppState(std::shared_ptr<const Catalog> catalog_, Document document_)
    : catalog(std::move(catalog_)), document(std::move(document_)), session(document) {
    document.take_changes();
    run(*this, "view.all");
}

bool asks(const AppState& state) {
    return state.prompt || state.recovery || state.merge || state.shared || state.home || has_dialog(state) || state.choosing || state.show_lists ||
           state.show_help || state.show_preferences || state.show_command_palette;
}

bool plays(const AppState& state) { return state.session.playing() && !asks(state); }

bool enabled(const AppState& state, std::string_view action) {
    return !blocked(state, action) && handler_of(action).enabled(state);
}

bool is_on(const AppState& state, std::string_view action) {
    const Handler& handler = handler_of(action);
    return handler.on && handler.on(state);
}

void run(AppState& state, std::string_view action) {
    state.source.read(state.document);  // typing ends here
    if (enabled(state, action)) {
        const int said = state.said;
        handler_of(action).run(state);
        if (state.said == said && !action.starts_with("view.")) forget_problem(state);
        return;
    }
    say(state, fmt::format("{}: not now", find_action(action)->label), true);
}

void say(AppState& state, const std::string& message, bool problem) {
    state.message = shown(message);
    state.message_is_problem = problem;
    ++state.said;
    state.occasion = {text_of(state), state.selection.nodes()};
}

void forget_problem(AppState& state) {
    if (state.message_is_problem) say(state, {});
}

void age_message(AppState& state, double seconds) {
    constexpr double readable = 6;
    state.occasion.age += seconds;
    if (!state.message_is_problem && !state.message.empty() && state.occasion.age > readable) say(state, {});
}

void go_to_step(AppState& state, std::size_t done) {
    Document& document = state.document;
    if (done == document.undo_steps() && !document.previewing()) return;
    document.go_to(done);
    say(state, done > 0 ? fmt::format("At: {}", document.step_label(done - 1)) : "At the beginning");
}

void ask_path(AppState& state, std::string action) {
    const std::string& underlay = state.aids.underlay.path;
    state.dialog_path = action == "underlay.open" && !underlay.empty() ? underlay : state.document.path();
    state.dialog_action = std::move(action);
}

void open_file(AppState& state, const std::string& path) {
    if (!blocked(state, "file.open")) guard(state, "file.open", path);
}

bool edit(AppState& state, const SetField& change, const std::string& label) {
    const std::optional<std::string> why = state.document.edit(change, label);
    if (why) say(state, *why, true);
    else say(state, label);
    return !why;
}

bool take(AppState& state, const Outcome& outcome) {
    if (outcome.refusal) return say(state, *outcome.refusal, true), false;
    select(state, outcome.nodes);
    say(state, outcome.done);
    return true;
}

void select(AppState& state, NodeId node) { select(state, node ? std::vector{node} : std::vector<NodeId>{}); }

void select(AppState& state, std::vector<NodeId> nodes) {
    state.selection = Selection(std::move(nodes));
    state.point.reset();
    state.entered = compound_around(state.document.scene(), state.selection.primary());
}

void add_node(AppState& state, const NodeType& type, const std::optional<Vec2>& world) {
    const Scene& scene = state.document.scene();
    Spot spot = spot_after(scene, state.selection.nodes());
    // A part stands at the top level or in a group, whatever is selected.
    while (spot.parent && misplaced_part(type, scene.find(spot.parent)->type, {}))
        spot = {scene.find(spot.parent)->parent, scene.index_of(spot.parent) + 1};
    take(state, insert_new(state.document, type, spot, world.value_or(state.view.centre)));
}

void wrap_selection(AppState& state, const NodeType& type) {
    take(state, wrap_nodes(state.document, state.selection.nodes(), type));
}

void advance(AppState& state, int ticks) {
    keep_safe(state);  // first of all: whatever comes of the edit, it is not lost
    if (auto shared = state.document.take_shared_edit(); shared && !asks(state)) state.shared = std::move(shared);
    ask_for_home(state);
    state.session.follow(state.document);
    tell_of_moved_balls(state);
    if (state.occasion.text != text_of(state) && !state.message.empty()) say(state, {});
    if (state.occasion.selected != state.selection.nodes()) forget_problem(state);
    follow_underlay(state);
    state.selection.drop_if([&](NodeId node) { return !state.document.scene().find(node); });
    if (!state.document.scene().find(state.entered)) state.entered = {};
    if (!asks(state)) state.session.advance(ticks);
}

bool is_table_key(const AppState& state, std::string_view key) {
    const std::vector<InputBinding>& inputs = state.document.scene().inputs;
    return std::any_of(inputs.begin(), inputs.end(), [&](const InputBinding& input) { return is_bound(input, key); });
}

bool press_key(AppState& state, std::string_view key, bool down) {
    for (const InputBinding& input : state.document.scene().inputs)
        if (is_bound(input, key)) state.session.press(input.name, down);
    return is_table_key(state, key);
}

}  // namespace pinfield::editor

#include "editor/actions.h"

#include <algorithm>

namespace pinfield::editor {

const std::vector<Action>& all_actions() {
    static const std::vector<Action> actions{
        {"file.new", "New...", "File", "Ctrl+N", "A new table, from one of the tables to begin with."},
        {"new.classic", "New classic table", "", "", "Two flippers, slings and a bumper."},
        {"new.fan", "New fan table", "", "", "An arch, a plunger and lanes that fan out from the flippers."},
        {"new.homework", "New bouncing ball", "", "", "One ball and some obstacles."},
        {"new.blank", "New blank table", "", "", "Four walls."},
        {"new.cancel", "Cancel", "", "", "Stay with the present table."},
        {"file.open", "Open...", "File", "Ctrl+O", "Open another table."},
        {"file.save", "Save", "File", "Ctrl+S", "Write what changed into the file, and nothing else."},
        {"file.save_as", "Save As...", "File", "Ctrl+Shift+S", "Write the table to another file and go on there."},
        {"file.reload", "Reload", "File", "", "Take what is on disk in place of what is edited; undo brings it back."},
        {"merge.ask", "Merge...", "File", "", "Make one of the table and of its file, which others have changed."},
        {"merge.mine_here", "Mine", "", "", "Of the value that is asked about, take mine."},
        {"merge.theirs_here", "Theirs", "", "", "Of the value that is asked about, take the file's."},
        {"merge.mine", "All mine", "", "", "Take mine of all that both have changed."},
        {"merge.theirs", "All theirs", "", "", "Take the file's of all that both have changed."},
        {"merge.accept", "Merge", "", "", "Make the table what was chosen; undo brings mine back."},
        {"merge.later", "Later", "", "", "Leave the table as it is; the file stays as it is, too."},
        {"app.quit", "Quit", "File", "Ctrl+Q", "Leave, asking about unsaved work first."},

        {"edit.undo", "Undo", "Edit", "Ctrl+Z", "Take the last change back; during a drag, the drag.", true},
        {"edit.redo", "Redo", "Edit", "Ctrl+Shift+Z", "Do again what was undone.", true},
        {"edit.cut", "Cut", "Edit", "Ctrl+X", "Take the selected nodes out, as YAML text."},
        {"edit.copy", "Copy", "Edit", "Ctrl+C", "Copy the selected nodes as YAML text, with their comments."},
        {"edit.paste", "Paste", "Edit", "Ctrl+V", "Put copied nodes, or YAML from anywhere, into the middle of the view."},
        {"edit.paste_in_place", "Paste in place", "Edit", "Ctrl+Shift+V", "Put copied nodes where they were copied from."},
        {"edit.duplicate", "Duplicate", "Edit", "Ctrl+D", "Copy the selected nodes beside themselves."},
        {"edit.delete", "Delete", "Edit", "Delete", "Take the selected nodes out, with all in them."},
        {"edit.select_all", "Select all", "Select", "Ctrl+A", "Select every node of the top level."},
        {"edit.add_material", "New material", "Edit", "", "Add a material with default values."},
        {"edit.lists", "Inputs and tests...", "Edit", "", "Name, bind, add and take out the table's inputs and tests."},
        {"lists.close", "Close", "", "", "Leave the inputs and tests as they are."},
        {"edit.group", "Group", "Edit", "Ctrl+G", "Put the selected nodes into a group of their own."},
        {"edit.unwrap", "Unwrap", "Edit", "Ctrl+Shift+G", "Take the children out of a group or operator; they stay where they are."},
        {"edit.rename", "Rename", "Edit", "F2", "Give the selected node another id; all that names it follows."},
        {"edit.move_up", "Move up", "Arrange", "Ctrl+Up", "Put the selected node before the one above it.", true},
        {"edit.move_down", "Move down", "Arrange", "Ctrl+Down", "Put the selected node behind the one below it.", true},
        {"edit.nudge_left", "Nudge left", "", "Left", "Move the selected nodes by the grid; with Shift by ten.", true},
        {"edit.nudge_right", "Nudge right", "", "Right", "Move the selected nodes by the grid; with Shift by ten.", true},
        {"edit.nudge_up", "Nudge up", "", "Up", "Move the selected nodes by the grid; with Shift by ten.", true},
        {"edit.nudge_down", "Nudge down", "", "Down", "Move the selected nodes by the grid; with Shift by ten.", true},
        {"edit.nudge_far_left", "Nudge far left", "", "Shift+Left", "Move the selected nodes by ten steps of the grid.", true},
        {"edit.nudge_far_right", "Nudge far right", "", "Shift+Right", "Move the selected nodes by ten steps of the grid.", true},
        {"edit.nudge_far_up", "Nudge far up", "", "Shift+Up", "Move the selected nodes by ten steps of the grid.", true},
        {"edit.nudge_far_down", "Nudge far down", "", "Shift+Down", "Move the selected nodes by ten steps of the grid.", true},
        {"edit.preferences", "Preferences...", "Edit", "Ctrl+,", "How the editor looks and works; kept from one run to the next."},
        {"edit.favourite", "Favourite in the palette", "Edit", "", "Put nodes of the selected one's type first in the palette, or no more."},
        {"edit.source", "Type in the source", "Edit", "Ctrl+E", "Go to the selected node's lines in the table's text, and type there."},
        {"select.find", "Find in the tree", "Select", "Ctrl+F", "Type a part of an id or type above the tree; Enter goes to the first node found."},
        {"select.parent", "Select the parent", "Select", "Alt+Up", "Select what the selected node lies in."},
        {"select.child", "Select the first child", "Select", "Alt+Down", "Select the first node in the selected one."},
        {"select.previous", "Select the one before", "Select", "Alt+Left", "Select the node before, among the same parent's.", true},
        {"select.next", "Select the next one", "Select", "Alt+Right", "Select the node behind, among the same parent's.", true},
        {"select.same_type", "Select all of this type", "Select", "", "Select every node of the selected one's type."},
        {"select.same_material", "Select all of this material", "Select", "", "Select every node that names the selected one's material."},
        {"edit.flip_x", "Mirror left to right", "Arrange", "", "Mirror the selected nodes in the upright line through their middle."},
        {"edit.flip_y", "Mirror top to bottom", "Arrange", "", "Mirror the selected nodes in the level line through their middle."},
        {"align.left", "Align left", "Arrange", "", "Put the left edges of the selected nodes in line with the outermost."},
        {"align.middle", "Align middle", "Arrange", "", "Put the selected nodes upon one upright line."},
        {"align.right", "Align right", "Arrange", "", "Put the right edges of the selected nodes in line with the outermost."},
        {"align.top", "Align top", "Arrange", "", "Put the upper edges of the selected nodes in line with the outermost."},
        {"align.centre", "Align centre", "Arrange", "", "Put the selected nodes upon one level line."},
        {"align.bottom", "Align bottom", "Arrange", "", "Put the lower edges of the selected nodes in line with the outermost."},
        {"align.space_x", "Space evenly across", "Arrange", "", "Make the gaps between the selected nodes equal; the outermost two stay."},
        {"align.space_y", "Space evenly upward", "Arrange", "", "Make the gaps between the selected nodes equal; the outermost two stay."},
        {"tool.select", "Select tool", "Arrange", "Q", "Select, move, and drag the handles of a node."},
        {"tool.move", "Move tool", "Arrange", "W", "Select and move; a node's handles are not in the way."},
        {"tool.turn", "Turn tool", "Arrange", "E", "A drag turns what is selected; with Shift by 15 degrees, with Ctrl freely."},
        {"tool.scale", "Scale tool", "Arrange", "R", "A drag scales what is selected; with Shift by tenths, with Ctrl freely."},
        {"tool.measure", "Measure tool", "Arrange", "M", "A drag measures from place to place, and how much room balls have on the way."},
        {"tool.snap", "Snap to others", "Arrange", "Shift+S", "Whether drags stop where edges and middles meet; Ctrl leaves it out once."},
        {"edit.deselect", "Deselect", "Select", "Esc", "Select nothing; during a drag, take it back."},

        {"play.toggle", "Play or pause", "Play", "F5", "Let the table run, or hold it."},
        {"play.pause", "Pause", "Play", "F6", "Hold the table."},
        {"play.step", "One tick", "Play", ".", "Advance by a single tick and hold.", true},
        {"play.reset", "Reset", "Play", "F7", "Balls to their starts, counters to zero."},
        {"play.slower", "Slower", "Play", "[", "Halve the speed, down to a 64th."},
        {"play.faster", "Faster", "Play", "]", "Double the speed, up to real time."},

        {"view.shaded", "Shaded", "View", "1", "Draw the table."},
        {"view.isolines", "Isolines", "View", "2", "Draw the signed distance field."},
        {"view.frame", "Frame the selection", "View", "F", "Fit the selected node into the viewport; without one, the table."},
        {"view.all", "Frame the table", "View", "Home", "Fit the whole table into the viewport."},
        {"view.zoom_in", "Zoom in", "View", "=", "Closer, about the middle.", true},
        {"view.zoom_out", "Zoom out", "View", "-", "Farther, about the middle.", true},
        {"view.command_palette", "Find a command or node", "View", "Ctrl+Shift+P", "Type a few letters of anything that can be done, or of a node."},
        {"view.source", "Source", "View", "F4", "Show the table's text beside it, or hide it."},
        {"view.changes", "Changes in the source", "View", "", "Mark the lines of the source that differ from the saved file."},

        {"view.rulers", "Rulers", "View", "Shift+R", "Show or hide the rulers at the table's edges; guides are dragged out of them."},
        {"view.guides", "Guides", "View", "Ctrl+;", "Show or hide the guides; what is hidden holds nothing."},
        {"view.lock_guides", "Lock the guides", "View", "", "Whether guides stay where they are under the mouse."},
        {"view.gaps", "Warn of narrow gaps", "View", "", "Whether drags tell of gaps that are too narrow for a ball."},
        {"guide.upright", "Upright guide here", "", "", "Put a guide at the mouse, or in the middle of the view."},
        {"guide.level", "Level guide here", "", "", "Put a guide at the mouse, or in the middle of the view."},
        {"guide.clear", "Remove all guides", "", "", "Take every guide of this table away."},
        {"view.panels", "Table alone", "View", "F11", "Hide all panels, or show them again."},
        {"view.history", "History", "View", "F9", "Show or hide the steps that were made, below the inspector; a click goes to one."},
        {"view.palette", "Palette", "View", "F8", "Show or hide what can be added, below the tree."},

        {"theme.dark", "Dark theme", "View", "", "Light words on dark panels."},
        {"theme.light", "Light theme", "View", "", "Dark words on light panels."},
        {"font.larger", "Larger text", "View", "Ctrl+=", "Larger text, and everything with it."},
        {"font.smaller", "Smaller text", "View", "Ctrl+-", "Smaller text, and everything with it."},
        {"font.usual", "Usual text", "View", "Ctrl+0", "Text of its usual size."},
        {"grid.off", "No grid", "", "", "What is dragged takes any place."},
        {"grid.tenth", "Grid of 0.1 mm", "", "", "What is dragged, and what arrow keys move, goes by tenths of a millimetre."},
        {"grid.1mm", "Grid of 1 mm", "", "", "What is dragged, and what arrow keys move, goes by whole millimetres."},
        {"grid.2mm", "Grid of 2 mm", "", "", "What is dragged, and what arrow keys move, goes by two millimetres."},
        {"grid.5mm", "Grid of 5 mm", "", "", "What is dragged, and what arrow keys move, goes by five millimetres."},
        {"grid.10mm", "Grid of 10 mm", "", "", "What is dragged, and what arrow keys move, goes by whole centimetres."},
        {"preferences.usual", "Usual preferences", "", "", "Every preference as it was at first."},
        {"preferences.close", "Close the preferences", "", "", "Done with the preferences."},

        {"help.keys", "Keys", "Help", "F1", "Every action and its key."},

        {"prompt.save", "Save", "", "", "Save, then go on with what was asked."},
        {"prompt.discard", "Discard", "", "", "Go on without saving."},
        {"prompt.cancel", "Cancel", "", "", "Stay."},
        {"shared.everywhere", "All of them", "", "", "Change what is shared where it stands, for every place that has it."},
        {"shared.here", "Here only", "", "", "Give this place a copy of its own of what is shared, and change that."},
        {"shared.cancel", "Cancel", "", "", "Change nothing."},
        {"recover.restore", "Restore", "", "", "Put the unsaved work that was found over the table, as one step."},
        {"recover.discard", "Discard", "", "", "Remove the unsaved work that was found."},
        {"recover.later", "Later", "", "", "Leave the unsaved work that was found for another time."},
        {"source.try_again", "Try the typed source again", "", "", "Read the typed text once more, over the table as it is now."},
        {"source.discard", "Discard the typed source", "", "", "Drop what was typed in the source and does not read."},
        {"dialog.accept", "OK", "", "", "Take the path that was typed."},
        {"dialog.cancel", "Cancel", "", "", "Name no path."},
    };
    return actions;
}

const Action* find_action(std::string_view name) {
    const auto found = std::find_if(all_actions().begin(), all_actions().end(), [&](const Action& action) { return action.name == name; });
    return found == all_actions().end() ? nullptr : &*found;
}

const Action* action_of(std::string_view shortcut) {
    if (shortcut.empty()) return nullptr;
    const auto found =
        std::find_if(all_actions().begin(), all_actions().end(), [&](const Action& action) { return action.shortcut == shortcut; });
    return found == all_actions().end() ? nullptr : &*found;
}

}  // namespace pinfield::editor

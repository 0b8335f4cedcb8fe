#include "editor/widgets/imgui_bridge.h"
#include "editor/widgets/widgets.h"
#include "engine/core/keys.h"

#include <imgui_impl_opengl3.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>


namespace pinfield::editor {

namespace {

struct KeyPair {
    ImGuiKey imgui;
    const char* name;
};

constexpr std::array navigation_keys = {
    KeyPair{ImGuiKey_Tab, "Tab"},       KeyPair{ImGuiKey_LeftArrow, "Left"}, KeyPair{ImGuiKey_RightArrow, "Right"},
    KeyPair{ImGuiKey_UpArrow, "Up"},    KeyPair{ImGuiKey_DownArrow, "Down"}, KeyPair{ImGuiKey_PageUp, "PageUp"},
    KeyPair{ImGuiKey_PageDown, "PageDown"}, KeyPair{ImGuiKey_Home, "Home"},  KeyPair{ImGuiKey_End, "End"},
    KeyPair{ImGuiKey_Insert, "Insert"}, KeyPair{ImGuiKey_Delete, "Delete"},  KeyPair{ImGuiKey_Backspace, "Backspace"},
    KeyPair{ImGuiKey_Space, "Space"},   KeyPair{ImGuiKey_Enter, "Enter"},    KeyPair{ImGuiKey_Escape, "Escape"},
    KeyPair{ImGuiKey_A, "A"},           KeyPair{ImGuiKey_C, "C"},            KeyPair{ImGuiKey_V, "V"},
    KeyPair{ImGuiKey_X, "X"},           KeyPair{ImGuiKey_Y, "Y"},            KeyPair{ImGuiKey_Z, "Z"},
};

void set_up_keys([[maybe_unused]] ImGuiIO& io) {
#if IMGUI_VERSION_NUM < 18700
    for (const KeyPair& key : navigation_keys) io.KeyMap[key.imgui] = key_code(key.name);
#endif
}

void hand_key_over(ImGuiIO& io, int code, bool down) {
    const std::string_view name = key_name(code);
    const bool control = name == "LeftControl" || name == "RightControl", shift = name == "LeftShift" || name == "RightShift";
    const bool alt = name == "LeftAlt" || name == "RightAlt";
#if IMGUI_VERSION_NUM < 18700
    if (code >= 0 && code < IM_ARRAYSIZE(io.KeysDown)) io.KeysDown[code] = down;
    if (control) io.KeyCtrl = down;
    if (shift) io.KeyShift = down;
    if (alt) io.KeyAlt = down;
#else
    if (control) io.AddKeyEvent(ImGuiMod_Ctrl, down);
    if (shift) io.AddKeyEvent(ImGuiMod_Shift, down);
    if (alt) io.AddKeyEvent(ImGuiMod_Alt, down);
    for (const KeyPair& key : navigation_keys)
        if (key.name == name) io.AddKeyEvent(key.imgui, down);
#endif
}

CursorShape shape_of(ImGuiMouseCursor cursor) {
    switch (cursor) {
        case ImGuiMouseCursor_TextInput: return CursorShape::text;
        case ImGuiMouseCursor_Hand: return CursorShape::hand;
        case ImGuiMouseCursor_ResizeEW: return CursorShape::resize_x;
        case ImGuiMouseCursor_ResizeNS: return CursorShape::resize_y;
        case ImGuiMouseCursor_ResizeAll: return CursorShape::move;
        default: return CursorShape::arrow;
    }
}

}  // namespace

ImGuiBridge::ImGuiBridge(Window& window) : window_(window) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // the layout is ours
    io.LogFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    io.ConfigInputTextCursorBlink = false;  // a picture taken by a script is the same each time
    set_up_keys(io);
#if IMGUI_VERSION_NUM < 19110
    io.ClipboardUserData = &window;
    io.SetClipboardTextFn = [](void* w, const char* text) { static_cast<Window*>(w)->set_clipboard(text); };
    io.GetClipboardTextFn = [](void* w) -> const char* {
        static std::string text;  // ImGui wants a text that outlives the call
        text = static_cast<Window*>(w)->clipboard();
        return text.c_str();
    };
#endif
    ImGui_ImplOpenGL3_Init(nullptr);
}

ImGuiBridge::~ImGuiBridge() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
}

void ImGuiBridge::hand_over(const WindowEvent& event) {
    ImGuiIO& io = ImGui::GetIO();
    using Kind = WindowEvent::Kind;
    const auto x = static_cast<float>(event.place.x()), y = static_cast<float>(event.place.y());
    switch (event.kind) {
#if IMGUI_VERSION_NUM < 18700
        case Kind::cursor: io.MousePos = {x, y}; break;
        case Kind::button:
            if (event.code < IM_ARRAYSIZE(io.MouseDown)) io.MouseDown[event.code] = event.down;
            break;
        case Kind::scroll:
            io.MouseWheelH += x;
            io.MouseWheel += y;
            break;
#else
        case Kind::cursor: io.AddMousePosEvent(x, y); break;
        case Kind::button: io.AddMouseButtonEvent(event.code, event.down); break;
        case Kind::scroll: io.AddMouseWheelEvent(x, y); break;
#endif
        case Kind::key: hand_key_over(io, event.code, event.down); break;
        case Kind::text: io.AddInputCharacter(event.character); break;
        case Kind::focus: io.AddFocusEvent(event.down); break;
        case Kind::drop:
        case Kind::close: break;
    }
}

std::vector<WindowEvent> ImGuiBridge::begin_frame(double seconds, bool menu_is_open) {
    std::vector<WindowEvent> handed;
    std::set<std::pair<WindowEvent::Kind, int>> changed;
    bool pressed = false;
    while (!pending_.empty()) {
        const WindowEvent& event = pending_.front();
        // One repeat a frame: where frames take longer, what is held must not go on after it is let go.
        if (event.repeat && !changed.insert({event.kind, event.code}).second) {
            pending_.pop_front();
            continue;
        }
        const bool is_switch = !event.repeat && (event.kind == WindowEvent::Kind::button || event.kind == WindowEvent::Kind::key);
        if (is_switch && !changed.insert({event.kind, event.code}).second) break;
        // A press happens where the mouse was, not where it has gone since.
        if (pressed && event.kind == WindowEvent::Kind::cursor) break;
        pressed = pressed || event.kind == WindowEvent::Kind::button;
        if (is_switch && event.down) held_.insert({event.kind, event.code});
        else if (is_switch) held_.erase({event.kind, event.code});
        hand_over(event);
        handed.push_back(event);
        pending_.pop_front();
    }
    ImGuiIO& io = ImGui::GetIO();
    const Vec2 size = window_.size(), framebuffer = window_.framebuffer();
    io.DisplaySize = {static_cast<float>(size.x()), static_cast<float>(size.y())};
    if (size.x() > 0 && size.y() > 0)
        io.DisplayFramebufferScale = {static_cast<float>(framebuffer.x() / size.x()), static_cast<float>(framebuffer.y() / size.y())};
    io.DeltaTime = static_cast<float>(std::max(seconds, 1e-4));
    ImGui_ImplOpenGL3_NewFrame();
    give_keys_to_menus(menu_is_open);
    ImGui::NewFrame();
    return handed;
}

void ImGuiBridge::renew_fonts() {
#if IMGUI_VERSION_NUM < 19200
    // Before the first frame there is no texture, and that frame makes one.
    const bool is_first = ImGui::GetFrameCount() == 0;
    if (is_first) return;
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
#endif
}

void ImGuiBridge::draw() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    window_.set_cursor(shape_of(ImGui::GetMouseCursor()));
}

}  // namespace pinfield::editor

#include "viewer/window.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <cstring>
#include <string>

namespace tsuya::viewer {

groom::Expected<std::unique_ptr<Window>> Window::create(int width, int height)
{
    const auto why = [](const char *what) {
        const char *text = nullptr;
        glfwGetError(&text);
        return groom::Error{std::string(what) + (text ? std::string(": ") + text : "")};
    };
    if (!glfwInit()) {
        return why("there is no display");
    }
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    GLFWwindow *window = glfwCreateWindow(width, height, "tsuya", nullptr, nullptr);
    if (!window) {
        const groom::Error error = why("there is no OpenGL 3.3 window");
        glfwTerminate();
        return error;
    }
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
    return groom::Expected<std::unique_ptr<Window>>(std::unique_ptr<Window>(new Window(window)));
}

Window::~Window()
{
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

bool Window::open() const
{
    return !glfwWindowShouldClose(window_);
}

Pointer Window::begin()
{
    glfwPollEvents();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();

    Pointer pointer;
    double x = 0.0, y = 0.0;
    glfwGetCursorPos(window_, &x, &y);
    const double dx = x - last_x_, dy = y - last_y_;
    last_x_ = x;
    last_y_ = y;
    const ImGuiIO &io = ImGui::GetIO();
    if (io.WantCaptureMouse) {
        return pointer;
    }
    const auto down = [&](int button) { return glfwGetMouseButton(window_, button) == GLFW_PRESS; };
    const bool pan = down(GLFW_MOUSE_BUTTON_RIGHT) || down(GLFW_MOUSE_BUTTON_MIDDLE) ||
                     (down(GLFW_MOUSE_BUTTON_LEFT) && io.KeyShift);
    if (pan) {
        pointer.pan_x = dx;
        pointer.pan_y = dy;
    } else if (down(GLFW_MOUSE_BUTTON_LEFT)) {
        pointer.orbit_x = dx;
        pointer.orbit_y = dy;
    }
    pointer.wheel = double(io.MouseWheel);
    return pointer;
}

void Window::end()
{
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(window_);
}

bool Window::pressed(int glfw_key)
{
    return !ImGui::GetIO().WantTextInput && ImGui::IsKeyPressed(glfw_key, false);
}

void Window::size(int &width, int &height) const
{
    glfwGetFramebufferSize(window_, &width, &height);
}

void *Window::proc(void *, const char *name)
{
    const GLFWglproc function = glfwGetProcAddress(name);
    void *address = nullptr;
    static_assert(sizeof address == sizeof function, "pointers to code and data differ");
    std::memcpy(&address, &function, sizeof address);
    return address;
}

} // namespace tsuya::viewer

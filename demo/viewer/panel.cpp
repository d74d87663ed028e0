#include "viewer/panel.h"

#include <tsuya/hair_color.h>
#include <tsuya/model.h>

#include <glm/common.hpp>
#include <glm/gtc/color_space.hpp>
#include <imgui.h>

#include <cstring>
#include <vector>

namespace tsuya::viewer {

namespace {

constexpr double degree = 0.01745329251994329577;

bool slide(const char *label, double &value, double low, double high, bool log = false)
{
    return ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &low, &high, "%.4g",
                               log ? ImGuiSliderFlags_Logarithmic : 0);
}

bool pick(const char *label, std::string &value, const std::vector<const char *> &words)
{
    bool changed = false;
    if (ImGui::BeginCombo(label, value.c_str())) {
        for (const char *word : words) {
            if (ImGui::Selectable(word, value == word) && value != word) {
                value = word;
                changed = true;
            }
        }
        ImGui::EndCombo();
    }
    return changed;
}

void models(scene::Scene &scene)
{
    std::vector<const char *> names;
    for (uint32_t i = 0; i < tsu_model_count(); i++) {
        tsu_model_info info;
        tsu_model_info_init(&info);
        tsu_model_describe(tsu_model_at(i), &info);
        names.push_back(info.name);
    }
    pick("model", scene.model, names);

    const tsu_model *model = tsu_model_find(scene.model.c_str());
    tsu_model_info info;
    tsu_model_info_init(&info);
    tsu_model_describe(model, &info);
    for (uint32_t i = 0; i < info.parameter_count; i++) {
        tsu_parameter_info p;
        tsu_parameter_info_init(&p);
        tsu_model_parameter(model, i, &p);
        if (p.count != 1) {
            continue; // a colour; it has its own controls
        }
        const bool angle = !std::strcmp(p.unit, "rad");
        const double unit = angle ? degree : 1.0;
        const auto given = scene.parameters.find(p.name);
        double value = given == scene.parameters.end() ? p.default_value / unit : given->second.x;
        const std::string label = std::string(p.name) + (angle ? " (degrees)" : "");
        if (slide(label.c_str(), value, p.minimum / unit, p.maximum / unit)) {
            scene.parameters[p.name] = glm::dvec3(value, 0.0, 0.0);
        }
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", p.help);
        }
    }
}

void colors(scene::Scene &scene)
{
    std::vector<const char *> names;
    for (uint32_t i = 0; i < tsu_hair_preset_count(); i++) {
        tsu_hair_preset_info info;
        tsu_hair_preset_info_init(&info);
        tsu_hair_preset(i, &info);
        names.push_back(info.name);
        if (scene.color_by == scene::ColorBy::preset && scene.color == info.name) {
            scene.eumelanin = info.eumelanin;
            scene.pheomelanin = info.pheomelanin;
        }
    }
    if (pick("colour", scene.color, names)) {
        scene.color_by = scene::ColorBy::preset;
    }
    const bool dark = slide("eumelanin", scene.eumelanin, 0.0, 10.0);
    const bool red = slide("pheomelanin", scene.pheomelanin, 0.0, 10.0);
    if (dark || red) {
        scene.color_by = scene::ColorBy::melanin;
    }
    // The wheel shows sRGB; an albedo is linear. No pigment makes hair blacker than its surfaces.
    const glm::vec3 seen = glm::convertLinearToSRGB(glm::vec3(scene.head_albedo));
    float wheel[3] = {seen.x, seen.y, seen.z};
    if (ImGui::ColorEdit3("of the head", wheel, ImGuiColorEditFlags_Float)) {
        const glm::vec3 linear = glm::convertSRGBToLinear(glm::vec3(wheel[0], wheel[1], wheel[2]));
        scene.head_albedo = glm::clamp(glm::dvec3(linear), 0.035, 1.0);
        scene.color_by = scene::ColorBy::head_albedo;
    }
    slide("variation", scene.variation, 0.0, 1.0);
}

void lights(scene::Scene &scene)
{
    pick("lights", scene.light, {"key", "front", "side", "back", "none"});
    slide("dome", scene.dome, 0.0, 10.0);
    // A file is chosen on the command line and stays until another is picked.
    pick("surroundings", scene.environment, {"none", "gradient", "sunset", "window"});
    pick("hair shadow", scene.shadow, {"grid", "deep_opacity", "opacity_shadow", "none"});
    slide("exposure", scene.exposure, -5.0, 5.0);
    bool film = scene.tone == "film";
    if (ImGui::Checkbox("film curve", &film)) {
        scene.tone = film ? "film" : "none";
    }
}

bool hair(scene::Scene &scene)
{
    bool grow = false;
    if (scene.groom.rfind("file:", 0) != 0) {
        grow = pick("style", scene.groom, {"straight", "wavy", "curly"});
        double strands = scene.hair.count("strands") ? scene.hair["strands"] : 20000.0;
        slide("strands", strands, 100.0, 100000.0, true);
        if (ImGui::IsItemDeactivatedAfterEdit()) {
            grow = true;
        }
        scene.hair["strands"] = double(int(strands));
    }
    slide("width scale", scene.width_scale, 0.1, 20.0, true);
    slide("taper", scene.taper, 0.0, 1.0);
    return grow;
}

} // namespace

Asked Panel::show(scene::Scene &scene)
{
    Asked asked;
    ImGui::SetNextWindowPos({8.0f, 8.0f}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({330.0f, 620.0f}, ImGuiCond_FirstUseEver);
    ImGui::Begin("tsuya");
    ImGui::Text("%.1f ms, %zu strands", milliseconds, strands);
    if (ImGui::CollapsingHeader("material", ImGuiTreeNodeFlags_DefaultOpen)) {
        models(scene);
        ImGui::Separator();
        colors(scene);
    }
    if (ImGui::CollapsingHeader("light", ImGuiTreeNodeFlags_DefaultOpen)) {
        lights(scene);
    }
    if (ImGui::CollapsingHeader("hair", ImGuiTreeNodeFlags_DefaultOpen)) {
        asked.grow = hair(scene);
    }
    ImGui::Separator();
    ImGui::InputText("file", file, sizeof file);
    asked.screenshot = ImGui::Button("save .png or .exr");
    ImGui::SameLine();
    asked.reload = ImGui::Button("reload GLSL (F5)");
    ImGui::TextWrapped("left: orbit, right: pan, wheel: zoom\n%s", message.c_str());
    ImGui::End();
    return asked;
}

} // namespace tsuya::viewer

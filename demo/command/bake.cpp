// `tsuya bake`: a material's texture and block page, as files.
#include "arguments.h"
#include "commands.h"
#include "function.h"
#include "host.h"
#include "material.h"
#include "number.h"
#include "texture.h"

#include "../image/file.h"

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using namespace tsuya::command;

Manual manual()
{
    return {
        "bake",
        "MODEL [KEY=VALUE ...] -o FILE [--block FILE] [--variant NAME]",
        "Bakes the tables of one material and writes the texture that tsu_tables samples and\n"
        "the page that tsu_materials holds. The material is number 0 of the page.\n"
        "\n"
        "Keys are the model's parameters (tsuya models MODEL). Angles are radians under their\n"
        "name and degrees with _deg: beta_R=0.13 or beta_R_deg=7.5. Colours are r,g,b or one\n"
        "number. Absorption can be said in one of five ways:\n"
        "  sigma_a=r,g,b              per fibre radius, linear Rec. 709\n"
        "  eumelanin=X pheomelanin=Y  pigments\n"
        "  color=NAME                 " +
            joined(preset_names()) +
            "\n"
            "  albedo=r,g,b               of one fibre\n"
            "  head_albedo=r,g,b          of thick hair: the colour that is seen\n"
            "\n"
            "The ending of FILE chooses the format:\n"
            "  .exr  float channels R, G, B, A; first row of the texture first\n"
            "  .csv  x,y,r,g,b,a, one line a texel\n"
            "  .bin  32 bytes of header, then width x height RGBA half floats, first row first.\n"
            "        Header, little-endian: \"TSUYATEX\", then six 32-bit numbers: version 1, "
            "offset\n"
            "        of the texels 32, width, height, channels 4, bytes of a channel 2\n"
            "A model without tables writes one texel of zeros.\n"
            "The block is 16384 bytes, vec4[1024] of little-endian floats, std140.\n"
            "\n"
            "Prints sizes, the time of the bake on one core, and the errors of the tables "
            "measured\n"
            "for this very material (seconds).\n",
        {{"-o", "FILE", "texture, .exr, .csv or .bin"},
         {"--block", "FILE", "page of the uniform block"},
         {"--variant", "NAME", "with the tables of this variant alone as well"},
         {"--no-measure", "", "do not measure the errors"}},
        "  tsuya bake marschner -o hair.exr\n"
        "  tsuya bake marschner eta=1.5 beta_az_deg=12 color=blond -o hair.bin --block "
        "hair.block\n"};
}

// A target that is a folder, a device or a pipe would be replaced by the finished file.
bool target_is_plain(const std::string &path, std::string &error)
{
    std::error_code code;
    const std::filesystem::file_status status = std::filesystem::status(path, code);
    if (path.empty() ||
        (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))) {
        error = "\"" + path + "\" is not a regular file.";
        return false;
    }
    return true;
}

bool write_block(const std::string &path, const float *page, std::string &error)
{
    return tsuya::image::replace_file(
        path,
        [&](std::FILE *file, std::string &why) {
            why = "the disk is full";
            return std::fwrite(page, 1, TSU_PAGE_BYTES, file) == TSU_PAGE_BYTES;
        },
        error);
}

// Where a stated error of this name comes from, for the reader of a measured one.
std::string measure_of(const tsu_model *model, const std::string &name)
{
    tsu_error_info info;
    tsu_error_info_init(&info);
    for (std::uint32_t i = 0; tsu_model_error(model, i, &info) == TSU_OK; i++) {
        if (name == info.name) {
            return std::string(" ") + info.measure + " (stated: " + number_text(info.value, 3) +
                   ")";
        }
    }
    return "";
}

std::string measured(tsu_set *set, std::uint32_t material, const tsu_model *model)
{
    std::string text;
    const char *name = nullptr;
    double value = 0;
    for (std::uint32_t i = 0; tsu_set_measure(set, material, i, &name, &value) == TSU_OK; i++) {
        text += std::string("error    ") + name + ": " + number_text(value, 3) +
                measure_of(model, name) + "\n";
    }
    return text;
}

int bake(const Arguments &arguments, const tsu_model *model, Texture::Format format)
{
    const std::string path = arguments.get("-o"), block = arguments.get("--block");
    Host host(Host::Jobs::one_core);
    Material material(host, model);
    std::string error;
    for (std::size_t i = 1; i < arguments.positional().size(); i++) {
        if (!material.set(arguments.positional()[i], error)) {
            return complain("bake", error, exit_bad_input);
        }
    }
    if (!material.finish(error) ||
        (arguments.has("--variant") && !material.vary(arguments.get("--variant"), error))) {
        return complain("bake", error, exit_bad_input);
    }
    Set set(host);
    std::uint32_t index = 0;
    tsu_status status = tsu_set_add(set.get(), model, material.params(), &index);
    const auto start = std::chrono::steady_clock::now();
    if (status == TSU_OK) {
        status = tsu_set_bake(set.get());
    }
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    if (status != TSU_OK) {
        return complain("bake", host.why(status) + ".", exit_failure);
    }
    // The block waits under another name until the texture is there: both files or none.
    const std::string waiting = block + ".part";
    if (!block.empty() && !write_block(waiting, tsu_set_page(set.get(), 0, nullptr), error)) {
        return complain("bake", error, exit_failure);
    }
    const Texture texture(set.get());
    std::error_code code;
    if (!texture.write(path, format, error)) {
        std::filesystem::remove(waiting, code);
        return complain("bake", error, exit_failure);
    }
    if (!block.empty()) {
        std::filesystem::rename(waiting, block, code);
        if (code) {
            return complain("bake", block + " cannot be written: " + code.message() + ".",
                            exit_failure);
        }
    }
    std::string text = "texture  " + path + ": " + std::to_string(texture.width()) + " x " +
                       std::to_string(texture.height()) + " RGBA16F, " +
                       std::to_string(texture.bytes()) + " bytes in memory\n";
    if (!block.empty()) {
        text += "block    " + block + ": " + std::to_string(TSU_PAGE_BYTES) + " bytes\n";
    }
    text += "time     " + number_text(time.count(), 3) + " ms on one core\n";
    if (!arguments.has("--no-measure")) {
        text += measured(set.get(), index, model);
    }
    return print("bake", text);
}

} // namespace

int command_bake(int argc, char **argv)
{
    Arguments arguments;
    std::string error;
    if (!arguments.parse(manual(), argc, argv, error)) {
        return complain("bake", error, exit_bad_input);
    }
    if (arguments.help()) {
        return print("bake", help_text(manual()));
    }
    if (arguments.positional().empty()) {
        return complain("bake", "no model is given; the models are " + joined(model_names()) + ".",
                        exit_bad_input);
    }
    const tsu_model *const model = find_model(arguments.positional()[0], error);
    Texture::Format format;
    if (!model || !Texture::format_of(arguments.get("-o"), format, error) ||
        !target_is_plain(arguments.get("-o"), error) ||
        (arguments.has("--block") && !target_is_plain(arguments.get("--block"), error))) {
        return complain("bake", error, exit_bad_input);
    }
    tsu_model_info info;
    tsu_model_info_init(&info);
    tsu_model_describe(model, &info);
    if (info.flags & TSU_MODEL_SHADOW) {
        return complain("bake", std::string(info.name) + " casts shadow: it has nothing to bake.",
                        exit_bad_input);
    }
    if (std::filesystem::path(arguments.get("-o")).lexically_normal() ==
        std::filesystem::path(arguments.get("--block")).lexically_normal()) {
        return complain("bake", "-o and --block name the same file.", exit_bad_input);
    }
    return bake(arguments, model, format);
}

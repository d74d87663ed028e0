// `tsuya choose`: which tier a scene requires.
#include "arguments.h"
#include "commands.h"
#include "host.h"
#include "json.h"
#include "question.h"

#include <tsuya/choose.h>
#include <tsuya/shader.h>

#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace tsuya;
using command::Json;
using command::Question;

int complain(const std::string &text, int code = command::exit_bad_input)
{
    const bool dot = !text.empty() && (text.back() == '.' || text.back() == '\n');
    return command::complain("choose", text + (dot ? "" : "."), code);
}

const command::Manual &manual()
{
    static const command::Manual text = {
        "choose",
        "SCENE|FILE [key=value ...] [bound=B] [luminance_bound=L] [budget=CLOCKS] [--json]",
        "Print the tier that a scene requires, with its predicted error and cost and the reason:\n"
        "the cheapest within the bounds, or the best within the budget (tsuya/choose.h). SCENE\n"
        "and keys are those of tsuya render. Nothing is drawn.\n\n"
        "Words of this command, not keys of a scene:\n"
        "  bound=B             the error that is allowed, a share (0.3 is 30 %): of hair the rms\n"
        "                      that tsuya compare prints, of leaves that of BRDF and BTDF\n"
        "  luminance_bound=L   the same for the error of the mean luminance\n"
        "  budget=CLOCKS       a pixel may cost, all lights together\n"
        "  samplers=N          texture units that are free, default 16\n"
        "  memory=BYTES        for tables, default 4294967295\n"
        "  previous=TIER       tier of the frame before; kept within hysteresis=H, default 0.1\n\n"
        "shadow= of the scene says what the host knows of the fibres in a light's way: none\n"
        "nothing (and tier=unshadowed is all that is left), grid counts of its own, deep_opacity\n"
        "and opacity_shadow that it can draw maps. Model and variant of hair do not matter; a "
        "leaf\n"
        "whose model is leaf wants its gloss.\n\n"
        "Status: met; missed, no tier is within the bounds, and the nearest is printed with what\n"
        "it misses by; over_budget, none is within the budget; conflict, none is within both. All\n"
        "four end with exit code 0; a scene that cannot be ends with 2 and names the field.",
        {{"--size", "WxH", "short for size=WxH"},
         {"--target", "GPU",
          "whose clocks are counted: navi21 (default), navi10, vega10,\ngfx1100"},
         {"--json", "", "print JSON, with the traits of the scene and every tier"}},
        "  tsuya choose straight-brown bound=0.35\n"
        "  tsuya choose wavy-blond camera.zoom=0.2 bound=0.3 budget=2000 --json\n"
        "  tsuya choose tree-backlit bound=0.05\n"};
    return text;
}

std::vector<std::string> bits(std::uint32_t value,
                              const std::vector<std::pair<std::uint32_t, const char *>> &names)
{
    std::vector<std::string> set;
    for (const auto &name : names) {
        if (value & name.first) {
            set.push_back(name.second);
        }
    }
    return set;
}

std::vector<std::string> dropped(std::uint32_t drop)
{
    return bits(drop, {{TSU_SHADER_DROP_TRT, "trt"},
                       {TSU_SHADER_DROP_RESIDUAL, "residual"},
                       {TSU_SHADER_DROP_BACK, "back"},
                       {TSU_SHADER_DROP_TRANSMITTED, "transmitted"}});
}

std::vector<std::string> passes(std::uint32_t set)
{
    return bits(set, {{TSU_PASS_COUNT, "count"}, {TSU_PASS_MAPS, "maps"}, {TSU_PASS_BLUR, "blur"}});
}

std::vector<std::string> outside(std::uint32_t set)
{
    return bits(set, {{TSU_OUTSIDE_SIGMA_A, "sigma_a"},
                      {TSU_OUTSIDE_SKY_SHARE, "sky_share"},
                      {TSU_OUTSIDE_LIGHT_COSINE, "light_cosine"},
                      {TSU_OUTSIDE_STRAND_PIXELS, "strand_pixels"},
                      {TSU_OUTSIDE_DEPTH, "depth"},
                      {TSU_OUTSIDE_CURL, "curl"},
                      {TSU_OUTSIDE_BETA_R, "beta_R"},
                      {TSU_OUTSIDE_COLOR, "colour"},
                      {TSU_OUTSIDE_CURVATURE, "curvature"}});
}

std::vector<std::string> lacking(std::uint32_t set)
{
    return bits(set, {{TSU_LACKS_SHADOW, "shadow"},
                      {TSU_LACKS_SAMPLERS, "samplers"},
                      {TSU_LACKS_MEMORY, "memory"},
                      {TSU_LACKS_MAP, "map"},
                      {TSU_LACKS_COAT, "coat"}});
}

const char *status_name(tsu_choice_status status)
{
    switch (status) {
    case TSU_CHOICE_MET:
        return "met";
    case TSU_CHOICE_MISSED:
        return "missed";
    case TSU_CHOICE_OVER_BUDGET:
        return "over_budget";
    default:
        return "conflict";
    }
}

tsu_tier_info described(tsu_tier tier)
{
    tsu_tier_info info;
    tsu_tier_info_init(&info);
    tsu_tier_describe(tier, &info);
    return info;
}

const char *model_name(const tsu_model *model)
{
    tsu_model_info info;
    tsu_model_info_init(&info);
    tsu_model_describe(model, &info);
    return info.name;
}

std::string words_or(const std::vector<std::string> &words, const char *none)
{
    return words.empty() ? none : command::joined(words);
}

std::string other(tsu_tier tier, float error, float cost)
{
    if (tier == TSU_TIER_NONE) {
        return "none";
    }
    char text[128];
    std::snprintf(text, sizeof text, "%s: error %.3g %%, %.4g clocks", described(tier).name,
                  100.0 * double(error), double(cost));
    return text;
}

std::string plain(const Question &question, const tsu_choice &choice)
{
    std::string text = question.said;
    const auto line = [&](const char *name, const std::string &value) {
        std::string left = name;
        left.resize(17, ' ');
        text += left + value + "\n";
    };
    char number[160];
    const std::string variant = *choice.variant ? std::string(", variant ") + choice.variant : "";
    line("tier", described(choice.tier).name);
    line("model", model_name(choice.model) + variant);
    std::snprintf(number, sizeof number, choice.miss > 0.0f ? ", misses by %.3g %%" : "",
                  100.0 * double(choice.miss));
    std::string status = status_name(choice.status);
    status += number;
    std::snprintf(number, sizeof number, choice.over > 0.0f ? ", over the budget by %.3g %%" : "",
                  100.0 * double(choice.over));
    line("status", status + number + (choice.flags & TSU_CHOICE_HELD ? ", kept from before" : ""));
    line("lobes dropped", words_or(dropped(choice.drop), "none"));
    line("passes", words_or(passes(choice.passes), "none"));
    std::snprintf(number, sizeof number, "%.3g %%, with its margin %.3g %%",
                  100.0 * double(choice.error), 100.0 * double(choice.error_high));
    line("error", number);
    std::snprintf(number, sizeof number, "%+.3g %%, with its margin %.3g %%",
                  100.0 * double(choice.luminance), 100.0 * double(choice.luminance_high));
    line("luminance", number);
    std::snprintf(number, sizeof number, "%.4g clocks a pixel on %s, %.3g a frame",
                  double(choice.cost), question.gpu.c_str(), double(choice.frame_cost));
    line("cost", number);
    line("tables", std::to_string(choice.bytes) + " bytes, " + std::to_string(choice.samplers) +
                       (choice.samplers == 1 ? " sampler" : " samplers"));
    line("next better", other(choice.better, choice.better_error, choice.better_cost));
    line("next cheaper", other(choice.cheaper, choice.cheaper_error, choice.cheaper_cost));
    line("not measured", words_or(outside(choice.outside), "nothing"));
    line("reason", choice.reason);
    return text;
}

void put_words(Json &json, const char *name, const std::vector<std::string> &words)
{
    json.key(name).open('[');
    for (const std::string &word : words) {
        json.value(std::string_view(word));
    }
    json.close();
}

void put_other(Json &json, const char *name, tsu_tier tier, float error, float cost)
{
    json.key(name);
    if (tier == TSU_TIER_NONE) {
        json.value(static_cast<const char *>(nullptr));
        return;
    }
    json.open('{')
        .field("tier", described(tier).name)
        .field("error", double(error))
        .field("cost", double(cost))
        .close();
}

void put_tiers(Json &json, const command::Host &host, const tsu_choose_desc &desc)
{
    json.key("tiers").open('[');
    for (std::uint32_t i = 0; i < tsu_tier_count(); i++) {
        const tsu_tier_info info = described(tsu_tier(i));
        tsu_prediction one;
        tsu_prediction_init(&one);
        if (info.kind != desc.kind ||
            tsu_choose_predict(host.context(), &desc, tsu_tier(i), &one) != TSU_OK) {
            continue;
        }
        json.open('{')
            .field("tier", info.name)
            .field("error", double(one.error))
            .field("error_high", double(one.error_high))
            .field("luminance", double(one.luminance))
            .field("luminance_high", double(one.luminance_high))
            .field("cost", double(one.cost));
        put_words(json, "lacks", lacking(one.lacks));
        json.close();
    }
    json.close();
}

std::string json_text(const Question &question, const tsu_choice &choice, const command::Host &host)
{
    Json json;
    json.open('{')
        .field("tier", described(choice.tier).name)
        .field("model", model_name(choice.model))
        .field("variant", choice.variant)
        .field("status", status_name(choice.status))
        .field("held", (choice.flags & TSU_CHOICE_HELD) != 0);
    put_words(json, "drop", dropped(choice.drop));
    put_words(json, "passes", passes(choice.passes));
    json.field("error", double(choice.error))
        .field("error_high", double(choice.error_high))
        .field("luminance", double(choice.luminance))
        .field("luminance_high", double(choice.luminance_high))
        .field("target", std::string_view(question.gpu))
        .field("cost", double(choice.cost))
        .field("frame_cost", double(choice.frame_cost))
        .field("bytes", std::uint64_t(choice.bytes))
        .field("samplers", std::uint64_t(choice.samplers))
        .field("miss", double(choice.miss))
        .field("over", double(choice.over));
    put_other(json, "better", choice.better, choice.better_error, choice.better_cost);
    put_other(json, "cheaper", choice.cheaper, choice.cheaper_error, choice.cheaper_cost);
    put_words(json, "outside", outside(choice.outside));
    json.field("reason", choice.reason).key("traits").open('{');
    for (const auto &trait : question.traits) {
        json.key(trait.first);
        if (trait.first == "shadow") {
            static const char *const names[] = {"none", "count", "maps"};
            json.value(names[question.desc.shadow - TSU_CHOOSE_SHADOW_NONE]);
        } else if (trait.second.size() == 1) {
            json.value(trait.second[0]);
        } else {
            json.open('[');
            for (const double value : trait.second) {
                json.value(value);
            }
            json.close();
        }
    }
    json.close();
    put_tiers(json, host, question.desc);
    return json.field("source", tsu_trade_source()).close().text();
}

} // namespace

int command_choose(int argc, char **argv)
{
    command::Arguments arguments;
    std::string error;
    if (!arguments.parse(manual(), argc, argv, error)) {
        return complain(error);
    }
    if (arguments.help()) {
        return command::print("choose", command::help_text(manual()));
    }
    const command::Host host;
    const groom::Expected<Question> question = command::question_of(host, arguments);
    if (!question) {
        return complain(question.error());
    }
    tsu_choice choice;
    tsu_choice_init(&choice);
    const tsu_status status = tsu_choose(host.context(), &question->desc, &choice);
    if (status != TSU_OK) {
        return complain(host.why(status));
    }
    return command::print("choose", arguments.has("--json") ? json_text(*question, choice, host)
                                                            : plain(*question, choice));
}

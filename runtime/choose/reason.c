#include "choose/reason.h"

#include "base/text.h"
#include "choose/trade.h"

static void put(struct tsu_i_line *line, const char *text)
{
    tsu_i_line_put(line, text);
}

static void put_whole(struct tsu_i_line *line, uint64_t value)
{
    char digits[24];
    size_t n = sizeof digits - 1;
    digits[n] = 0;
    do
        digits[--n] = (char)('0' + value % 10);
    while (value /= 10);
    put(line, digits + n);
}

// At least two digits that count, at most one behind the point.
static void put_number(struct tsu_i_line *line, double value)
{
    if (!(value < 1e15)) {
        put(line, "1e15 and more");
        return;
    }
    const uint64_t tenths = (uint64_t)(value * 10.0 + 0.5);
    if (tenths < 100 && tenths % 10) {
        put_whole(line, tenths / 10);
        put(line, ".");
        put_whole(line, tenths % 10);
    } else {
        put_whole(line, (uint64_t)(value + 0.5));
    }
}

static void put_percent(struct tsu_i_line *line, double share)
{
    put_number(line, share * 100.0);
    put(line, " %");
}

static const char *name(const struct tsu_i_candidate *candidate)
{
    return tsu_i_trade.tiers[candidate->tier].name;
}

static void put_tier(struct tsu_i_line *line, const struct tsu_i_candidate *candidate)
{
    put(line, name(candidate));
    put(line, ": error ");
    put_percent(line, candidate->error);
    if (candidate->high > candidate->error) {
        put(line, " (");
        put_percent(line, candidate->high);
        put(line, " with margin)");
    }
    put(line, ", ");
    put_number(line, candidate->cost);
    put(line, " clocks. ");
}

static void put_bounds(struct tsu_i_line *line, const tsu_choose_desc *desc)
{
    if (desc->error_bound > 0.0f) {
        put(line, "error ");
        put_percent(line, (double)desc->error_bound);
    }
    if (desc->luminance_bound > 0.0f) {
        put(line, desc->error_bound > 0.0f ? ", luminance " : "luminance ");
        put_percent(line, (double)desc->luminance_bound);
    }
}

static void put_over(struct tsu_i_line *line, const char *what, double share)
{
    put(line, what);
    put_percent(line, share);
    put(line, ". ");
}

static void put_status(struct tsu_i_line *line, const tsu_choose_desc *desc,
                       const struct tsu_i_field *field, const struct tsu_i_decision *d)
{
    const int bound = desc->error_bound > 0.0f || desc->luminance_bound > 0.0f;
    const double budget = (double)desc->cost_budget;
    switch (d->status) {
    case TSU_CHOICE_MET:
        if (!bound) {
            put(line, budget > 0.0 ? "The smallest error within the budget. "
                                   : "The smallest error of all. ");
            break;
        }
        put(line, d->within > 1 ? "The cheapest of " : "The only one of ");
        put_whole(line, d->within > 1 ? d->within : field->count);
        put(line, budget > 0.0 ? " within the budget and " : " within ");
        put_bounds(line, desc);
        put(line, ". ");
        break;
    case TSU_CHOICE_MISSED:
        put(line, "No tier is within ");
        put_bounds(line, desc);
        put_over(line, "; the nearest misses by ", d->chosen->excess - 1.0);
        break;
    case TSU_CHOICE_OVER_BUDGET:
        put_over(line, "The cheapest, and over the budget by ", d->chosen->cost / budget - 1.0);
        break;
    default:
        put(line, "What is within ");
        put_bounds(line, desc);
        put_over(line, " costs more than the budget; the nearest within it misses by ",
                 d->chosen->excess - 1.0);
    }
}

static void put_outside(struct tsu_i_line *line, uint32_t outside)
{
    static const char *const names[] = {"sigma_a",       "sky_share", "light_cosine",
                                        "strand_pixels", "depth",     "curl",
                                        "beta_R",        "colour",    "curvature"};
    const char *before = "Outside of what was measured: ";
    for (int i = 0; i < (int)(sizeof names / sizeof *names); i++)
        if (outside >> i & 1) {
            put(line, before);
            put(line, names[i]);
            before = ", ";
        }
    if (outside)
        put(line, ". ");
}

void tsu_i_reason(const tsu_choose_desc *desc, const struct tsu_i_field *field,
                  const struct tsu_i_decision *decision, char *text, size_t capacity)
{
    struct tsu_i_line line = {text, capacity, 0};
    text[0] = 0;
    put_tier(&line, decision->chosen);
    if (decision->held)
        put(&line, "Kept from the frame before, within the hysteresis. ");
    else
        put_status(&line, desc, field, decision);
    if (field->species) {
        put(&line, "Errors as of ");
        put(&line, field->species);
        put(&line, ". ");
    }
    put_outside(&line, field->outside);
    if (decision->cheaper && line.size + 80 < capacity) {
        put(&line, name(decision->cheaper));
        put(&line, " would err by ");
        put_percent(&line, decision->cheaper->error);
        put(&line, " for ");
        put_number(&line, decision->cheaper->cost);
        put(&line, ". ");
    }
    while (line.size > 0 && text[line.size - 1] == ' ')
        text[--line.size] = 0;
}

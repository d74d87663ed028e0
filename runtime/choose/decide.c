#include "choose/decide.h"

#include <stddef.h>

typedef const struct tsu_i_candidate *candidate;

// Costs this close count as equal.
static const double alike = 1.05;

struct wish {
    int bound;     // error, luminance or both
    double budget; // 0: none
};

static int affordable(const struct wish *wish, candidate c)
{
    return wish->budget <= 0.0 || c->cost <= wish->budget;
}

// Whether a is the better answer by its first measure, then by its second.
static int before(double a, double b, double a2, double b2)
{
    return a < b || (a == b && a2 < b2);
}

static candidate cheapest(const struct tsu_i_field *field, const struct wish *wish, int within)
{
    candidate best = NULL;
    for (uint32_t i = 0; i < field->count; i++) {
        candidate c = field->tiers + i;
        if (c->lacks || (within && (c->excess > 1.0 || !affordable(wish, c))))
            continue;
        if (!best || before(c->cost, best->cost, c->high, best->high))
            best = c;
    }
    return best;
}

// Of the tiers within the wish, those that cost about the least: the one of the smallest error.
static candidate good_and_cheap(const struct tsu_i_field *field, const struct wish *wish)
{
    candidate least = cheapest(field, wish, 1), best = least;
    for (uint32_t i = 0; i < field->count && least; i++) {
        candidate c = field->tiers + i;
        if (c->lacks || c->excess > 1.0 || !affordable(wish, c) || c->cost > least->cost * alike)
            continue;
        if (before(c->high, best->high, c->cost, best->cost))
            best = c;
    }
    return best;
}

// Of the affordable tiers the one that is nearest to the bounds; without bounds, of least error.
static candidate nearest(const struct tsu_i_field *field, const struct wish *wish)
{
    candidate best = NULL;
    for (uint32_t i = 0; i < field->count; i++) {
        candidate c = field->tiers + i;
        if (c->lacks || !affordable(wish, c))
            continue;
        const double mine = wish->bound ? c->excess : c->high;
        if (!best || before(mine, wish->bound ? best->excess : best->high, c->cost, best->cost))
            best = c;
    }
    return best;
}

static int any_within_bounds(const struct tsu_i_field *field)
{
    for (uint32_t i = 0; i < field->count; i++)
        if (!field->tiers[i].lacks && field->tiers[i].excess <= 1.0)
            return 1;
    return 0;
}

static candidate fresh(const struct tsu_i_field *field, const struct wish *wish,
                       tsu_choice_status *status)
{
    candidate best = wish->bound ? good_and_cheap(field, wish) : nearest(field, wish);
    *status = TSU_CHOICE_MET;
    if (best)
        return best;
    best = nearest(field, wish);
    *status = best && any_within_bounds(field) ? TSU_CHOICE_CONFLICT : TSU_CHOICE_MISSED;
    if (best)
        return best;
    *status = TSU_CHOICE_OVER_BUDGET;
    return cheapest(field, wish, 0);
}

// Whether the tier of the frame before may stay in place of the new answer.
static int stays(const struct wish *wish, double hysteresis, tsu_choice_status status,
                 candidate old, candidate answer)
{
    const double more = 1.0 + hysteresis;
    if (status == TSU_CHOICE_OVER_BUDGET)
        return old->cost <= more * answer->cost;
    if (wish->budget > 0.0 && old->cost > more * wish->budget)
        return 0;
    if (!wish->bound)
        return old->high <= more * answer->high;
    if (status == TSU_CHOICE_MET)
        return old->excess <= more && old->cost <= more * answer->cost;
    return old->excess <= more * answer->excess;
}

static void neighbours(const struct tsu_i_field *field, struct tsu_i_decision *out)
{
    for (uint32_t i = 0; i < field->count; i++) {
        candidate c = field->tiers + i;
        if (c->lacks)
            continue;
        if (c->error < out->chosen->error &&
            (!out->better || before(c->cost, out->better->cost, c->error, out->better->error)))
            out->better = c;
        if (c->cost < out->chosen->cost &&
            (!out->cheaper || before(c->error, out->cheaper->error, c->cost, out->cheaper->cost)))
            out->cheaper = c;
    }
}

void tsu_i_decide(const tsu_choose_desc *desc, const struct tsu_i_field *field,
                  struct tsu_i_decision *out)
{
    const struct wish wish = {desc->error_bound > 0.0f || desc->luminance_bound > 0.0f,
                              (double)desc->cost_budget};
    *out = (struct tsu_i_decision){0};
    candidate answer = fresh(field, &wish, &out->status);
    out->chosen = answer;
    if (!answer)
        return;
    for (uint32_t i = 0; i < field->count; i++) {
        candidate c = field->tiers + i;
        if (!c->lacks && c->excess <= 1.0 && affordable(&wish, c))
            out->within++;
        if (c->tier == desc->previous && c != answer && !c->lacks &&
            stays(&wish, (double)desc->hysteresis, out->status, c, answer)) {
            out->chosen = c;
            out->held = 1;
        }
    }
    neighbours(field, out);
}

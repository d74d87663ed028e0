#include "shade/strip.h"

#include <tsuya/shader.h>

#include <string.h>

static const struct {
    const char *name;
    unsigned flag;
} macros[] = {
    {"TSU_FINE", TSU_SHADER_FINE},
    {"TSU_DROP_TRT", TSU_SHADER_DROP_TRT},
    {"TSU_DROP_RESIDUAL", TSU_SHADER_DROP_RESIDUAL},
    {"TSU_DROP_BACK", TSU_SHADER_DROP_BACK},
    {"TSU_DROP_TRANSMITTED", TSU_SHADER_DROP_TRANSMITTED},
};

enum { DEPTH = 16 };

// A state of #if: whose it is, and whether its lines are wanted.
struct region {
    int ours, wanted;
};

static int is_word(char c)
{
    return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

static const char *skip(const char *at, const char *end)
{
    while (at < end && (*at == ' ' || *at == '\t'))
        at++;
    return at;
}

// `word` at `*at`, whole; goes past it and the blanks behind.
static int take(const char **at, const char *end, const char *word)
{
    const size_t size = strlen(word);
    if ((size_t)(end - *at) < size || memcmp(*at, word, size) != 0 ||
        (is_word(word[size - 1]) && *at + size < end && is_word((*at)[size])))
        return 0;
    *at = skip(*at + size, end);
    return 1;
}

// A macro of ours at `*at`: 1 and whether it is defined.
static int take_macro(const char **at, const char *end, unsigned flags, int *defined)
{
    for (size_t i = 0; i < sizeof macros / sizeof *macros; i++)
        if (take(at, end, macros[i].name)) {
            *defined = (flags & macros[i].flag) != 0;
            return 1;
        }
    return 0;
}

// Terms `defined(NAME)` and `!defined(NAME)` joined by ||.
static int take_terms(const char **at, const char *end, unsigned flags, int *value)
{
    *value = 0;
    do {
        const int negated = take(at, end, "!");
        int defined;
        if (!take(at, end, "defined") || !take(at, end, "(") ||
            !take_macro(at, end, flags, &defined) || !take(at, end, ")"))
            return 0;
        *value |= defined != negated;
    } while (take(at, end, "||"));
    return 1;
}

static struct region open_region(const char *at, const char *end, unsigned flags)
{
    struct region region = {0, 1};
    int value;
    if (take(&at, end, "ifdef"))
        region.ours = take_macro(&at, end, flags, &value);
    else if (take(&at, end, "ifndef")) {
        region.ours = take_macro(&at, end, flags, &value);
        value = !value;
    } else if (take(&at, end, "if"))
        region.ours = take_terms(&at, end, flags, &value);
    if (region.ours && at == end)
        region.wanted = value;
    else
        region.ours = 0;
    return region;
}

void tsu_i_strip(struct tsu_i_text *text, unsigned flags)
{
    struct region stack[DEPTH];
    int depth = 0;
    struct tsu_i_rewrite rewrite = tsu_i_rewrite_begin(text);
    for (size_t size; (size = tsu_i_rewrite_line(&rewrite)) > 0;) {
        const char *at = text->bytes + rewrite.read;
        const char *end = at + size;
        while (end > at && (end[-1] == '\n' || end[-1] == '\r' || end[-1] == ' '))
            end--;
        int keep = 1;
        for (int i = 0; i < depth && i < DEPTH; i++)
            keep = keep && stack[i].wanted;
        at = skip(at, end);
        if (take(&at, end, "#")) {
            const char *word = at;
            struct region *top = depth > 0 && depth <= DEPTH ? stack + depth - 1 : NULL;
            if (end - at > 1 && at[0] == 'i' && at[1] == 'f') {
                const struct region region = open_region(at, end, flags);
                if (depth < DEPTH)
                    stack[depth] = region;
                depth++;
                keep = keep && !(region.ours && depth <= DEPTH);
            } else if (take(&word, end, "else") && top && top->ours) {
                top->wanted = !top->wanted;
                keep = 0;
            } else if (take(&word, end, "endif") && depth > 0) {
                keep = keep && !(top && top->ours);
                depth--;
            }
        }
        tsu_i_rewrite_next(&rewrite, keep);
    }
    tsu_i_rewrite_end(&rewrite);
}

struct tsu_i_rewrite tsu_i_rewrite_begin(struct tsu_i_text *text)
{
    struct tsu_i_rewrite rewrite = {.text = text, .line = 1};
    return rewrite;
}

size_t tsu_i_rewrite_line(const struct tsu_i_rewrite *rewrite)
{
    const struct tsu_i_text *text = rewrite->text;
    size_t end = rewrite->read;
    while (end < text->size && text->bytes[end] != '\n')
        end++;
    return (end < text->size ? end + 1 : end) - rewrite->read;
}

// Number after blanks; 0 when there is none.
static unsigned number(const char **at)
{
    unsigned value = 0;
    while (**at == ' ')
        ++*at;
    while (**at >= '0' && **at <= '9')
        value = 10 * value + (unsigned)(*(*at)++ - '0');
    return value;
}

// In place of missing lines, what is shorter: their line ends, or where the next line stands. A
// line that is left out has at least its line end, so that either fits.
static void fill(struct tsu_i_rewrite *rewrite)
{
    char bytes[48];
    struct tsu_i_line line = {bytes, sizeof bytes, 0};
    tsu_i_line_put(&line, "#line ");
    tsu_i_line_unsigned(&line, rewrite->line);
    tsu_i_line_put(&line, " ");
    tsu_i_line_unsigned(&line, rewrite->source);
    tsu_i_line_put(&line, "\n");
    if (line.size > rewrite->missing) {
        memset(bytes, '\n', rewrite->missing);
        line.size = rewrite->missing;
    }
    memcpy(rewrite->text->bytes + rewrite->written, bytes, line.size);
    rewrite->written += line.size;
    rewrite->missing = 0;
}

void tsu_i_rewrite_next(struct tsu_i_rewrite *rewrite, int keep)
{
    char *bytes = rewrite->text->bytes;
    const size_t size = tsu_i_rewrite_line(rewrite);
    const int moves = size > 6 && memcmp(bytes + rewrite->read, "#line ", 6) == 0;
    const char *at = bytes + rewrite->read + 6;
    const unsigned line = moves ? number(&at) : rewrite->line + 1;
    const unsigned source = moves ? number(&at) : rewrite->source;
    if (!keep) {
        rewrite->missing++;
    } else {
        if (rewrite->missing && !moves)
            fill(rewrite);
        rewrite->missing = 0;
        memmove(bytes + rewrite->written, bytes + rewrite->read, size);
        rewrite->written += size;
    }
    rewrite->line = line;
    rewrite->source = source;
    rewrite->read += size;
}

void tsu_i_rewrite_end(struct tsu_i_rewrite *rewrite)
{
    rewrite->text->size = rewrite->written;
    if (rewrite->text->bytes)
        rewrite->text->bytes[rewrite->written] = 0;
}

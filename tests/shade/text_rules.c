#include "text_rules.h"

#include <ctype.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

char *text_without_comments(const char *text)
{
    char *out = malloc(strlen(text) + 1);
    assert_non_null(out);
    strcpy(out, text);
    for (char *c = out; *c;) {
        if (c[0] == '/' && c[1] == '/') {
            while (*c && *c != '\n')
                *c++ = ' ';
        } else if (c[0] == '/' && c[1] == '*') {
            while (*c && !(c[0] == '*' && c[1] == '/')) {
                if (*c != '\n')
                    *c = ' ';
                c++;
            }
            if (*c)
                c[0] = c[1] = ' ';
        } else {
            c++;
        }
    }
    return out;
}

static int is_word(char c)
{
    return isalnum((unsigned char)c) || c == '_';
}

static void put(struct globals *g, char kind, const char *start, const char *end)
{
    while (end > start && !is_word(end[-1]))
        end--;
    const char *from = end;
    while (from > start && is_word(from[-1]))
        from--;
    assert_true(g->count < GLOBALS_MOST);
    snprintf(g->items[g->count].name, sizeof g->items->name, "%.*s", (int)(end - from), from);
    g->items[g->count++].kind = kind;
}

static int begins(const char *start, const char *end, const char *word)
{
    const size_t n = strlen(word);
    return (size_t)(end - start) > n && memcmp(start, word, n) == 0 && !is_word(start[n]);
}

static const char *first_of(const char *start, const char *end, const char *set)
{
    while (start < end && !strchr(set, *start))
        start++;
    return start;
}

static int has(const char *start, const char *end, const char *word)
{
    const char *found = strstr(start, word);
    return found && found < end;
}

// One declaration, up to its ; or {.
static void declaration(struct globals *g, const char *start, const char *end, char stop)
{
    while (start < end && isspace((unsigned char)*start))
        start++;
    if (start == end || begins(start, end, "precision"))
        return;
    if (begins(start, end, "layout")) {
        start = first_of(start, end, ")");
        do
            start++;
        while (start < end && isspace((unsigned char)*start));
    }
    if (begins(start, end, "struct"))
        put(g, 's', start, end);
    else if (begins(start, end, "uniform"))
        put(g, stop == '{' ? 'b' : has(start, end, "sampler") ? 'u' : 'v', start,
            first_of(start, end, "["));
    else if (first_of(start, end, "(") < first_of(start, end, "=["))
        put(g, 'f', start, first_of(start, end, "("));
    else
        put(g, 'v', start, first_of(start, end, "=["));
}

void text_globals(const char *text, struct globals *out)
{
    char *plain = text_without_comments(text);
    memset(out, 0, sizeof *out);
    int depth = 0, block = 0;
    char *start = plain;
    for (char *c = plain; *c; c++) {
        if (*c == '#' && depth == 0) {
            char *line_end = c + strcspn(c, "\n");
            if (begins(c, line_end, "#define")) {
                char *name = c + 7 + strspn(c + 7, " ");
                put(out, 'm', name, name + strspn(name, "abcdefghijklmnopqrstuvwxyz"
                                                        "ABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789"));
            }
            c = line_end - 1;
            start = line_end;
        } else if (*c == '{' && depth++ == 0) {
            const int before = out->count;
            declaration(out, start, c, '{');
            block = out->count > before && out->items[before].kind == 'b';
            start = c + 1;
        } else if (*c == '}' && --depth == 0) {
            start = c + 1;
        } else if (*c == ';' && depth == 0) {
            declaration(out, start, c, ';');
            start = c + 1;
        } else if (*c == ';' && depth == 1 && block) {
            // A block without an instance name puts its members at file scope.
            put(out, 'v', start, first_of(start, c, "["));
            start = c + 1;
        }
    }
    assert_int_equal(depth, 0);
    free(plain);
}

int text_occurrences(const char *text, const char *word)
{
    int n = 0;
    for (const char *at = strstr(text, word); at; at = strstr(at + 1, word))
        n++;
    return n;
}

int globals_count(const struct globals *g, char kind, const char *name)
{
    int n = 0;
    for (int i = 0; i < g->count; i++)
        n += g->items[i].kind == kind && (!name || strcmp(g->items[i].name, name) == 0);
    return n;
}

#include "shade/reach.h"

#include "base/host.h"
#include "shade/strip.h"

#include <string.h>

// A declaration at file scope with the comment before it, as whole lines.
struct piece {
    size_t begin, end;
    size_t name, name_size; // 0 bytes: no name of ours
    unsigned source;
    int code; // 0: a comment alone
    int kept;
};

struct pieces {
    struct tsu_i_text *text;
    struct piece *list;
    size_t count, room;
};

static int is_word(char c)
{
    return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

static int begins(const struct tsu_i_text *text, size_t at, const char *word)
{
    const size_t size = strlen(word);
    return at + size <= text->size && memcmp(text->bytes + at, word, size) == 0;
}

static size_t next_line(const struct tsu_i_text *text, size_t at)
{
    while (at < text->size && text->bytes[at] != '\n')
        at++;
    return at < text->size ? at + 1 : at;
}

static size_t skip_blanks(const struct tsu_i_text *text, size_t at)
{
    while (at < text->size && (text->bytes[at] == ' ' || text->bytes[at] == '\t'))
        at++;
    return at;
}

// The end of a comment at `at`, or `at` when there is none.
static size_t comment_end(const struct tsu_i_text *text, size_t at)
{
    if (begins(text, at, "//"))
        while (at < text->size && text->bytes[at] != '\n')
            at++;
    else if (begins(text, at, "/*")) {
        at += 2;
        while (at < text->size && !begins(text, at, "*/"))
            at++;
        at = at < text->size ? at + 2 : at;
    }
    return at;
}

// The next word that begins with tsu_ or TSU_, from `at` to `end`; its size, or 0. Comments are
// none.
static size_t next_name(const struct tsu_i_text *text, size_t *at, size_t end)
{
    while (*at < end) {
        const size_t past = comment_end(text, *at);
        if (past > *at) {
            *at = past;
            continue;
        }
        if (!is_word(text->bytes[*at])) {
            ++*at;
            continue;
        }
        size_t size = 1;
        while (*at + size < end && is_word(text->bytes[*at + size]))
            size++;
        if (begins(text, *at, "tsu_") || begins(text, *at, "TSU_"))
            return size;
        *at += size;
    }
    return 0;
}

// A directive at `at`, with the lines it is continued on; conditionals to their #endif.
static size_t directive_end(const struct tsu_i_text *text, size_t at)
{
    int depth = 0;
    do {
        const size_t word = skip_blanks(text, skip_blanks(text, at) + 1);
        depth += begins(text, word, "if");
        depth -= begins(text, word, "endif");
        size_t line = at;
        do {
            line = at;
            at = next_line(text, at);
        } while (at - line > 1 && at < text->size && text->bytes[at - 2] == '\\');
        while (depth > 0 && at < text->size && text->bytes[skip_blanks(text, at)] != '#')
            at = next_line(text, at);
    } while (depth > 0 && at < text->size);
    return at;
}

// Past the ; or the } that ends a declaration, and the rest of its line.
static size_t declaration_end(const struct tsu_i_text *text, size_t at)
{
    int depth = 0;
    while (at < text->size) {
        const size_t past = comment_end(text, at);
        const char c = text->bytes[at];
        if (past > at) {
            at = past;
            continue;
        }
        at++;
        depth += c == '{' || c == '(';
        depth -= c == '}' || c == ')';
        if (depth <= 0 && (c == ';' || (c == '}' && text->bytes[skip_blanks(text, at)] != ';')))
            break;
    }
    return next_line(text, at);
}

// The name that a declaration gives: of a struct or macro the second word, of a function or a
// variable the first one of ours that ( or = or [ or ; follows.
static void find_name(const struct tsu_i_text *text, struct piece *piece, size_t at)
{
    const int leads = begins(text, at, "struct") || text->bytes[at] == '#';
    for (size_t size; (size = next_name(text, &at, piece->end)) > 0; at += size) {
        const size_t after = skip_blanks(text, at + size);
        const char c = after < text->size ? text->bytes[after] : ';';
        if (leads || c == '(' || c == '=' || c == '[' || c == ';') {
            piece->name = at;
            piece->name_size = size;
            return;
        }
    }
}

static int push(const tsu_context *context, struct pieces *pieces, const struct piece *piece)
{
    if (pieces->count == pieces->room) {
        const size_t room = 2 * pieces->room + 64;
        struct piece *grown =
            tsu_i_realloc(context, pieces->list, pieces->room, room, sizeof *grown);
        if (!grown)
            return 0;
        pieces->list = grown;
        pieces->room = room;
    }
    pieces->list[pieces->count++] = *piece;
    return 1;
}

static unsigned source_at(const struct tsu_i_text *text, size_t at)
{
    unsigned source = 0;
    at = skip_blanks(text, at + 6);
    while (at < text->size && text->bytes[at] >= '0' && text->bytes[at] <= '9')
        at++;
    for (at = skip_blanks(text, at); at < text->size && is_word(text->bytes[at]); at++)
        source = 10 * source + (unsigned)(text->bytes[at] - '0');
    return source;
}

static int split(const tsu_context *context, struct pieces *pieces)
{
    const struct tsu_i_text *text = pieces->text;
    unsigned source = 0;
    for (size_t at = 0; at < text->size;) {
        struct piece piece = {.begin = at, .source = source};
        size_t code = skip_blanks(text, at);
        if (begins(text, at, "#line ")) {
            source = source_at(text, at);
            at = next_line(text, at);
            continue;
        }
        if (text->bytes[code] == '\n') {
            at = next_line(text, at);
            continue;
        }
        // Comments belong to the declaration that follows without an empty line.
        for (size_t past; (past = comment_end(text, code)) > code;)
            code = skip_blanks(text, next_line(text, past));
        piece.end = code;
        piece.code =
            code < text->size && text->bytes[code] != '\n' && !begins(text, code, "#line ");
        if (piece.code) {
            piece.end =
                text->bytes[code] == '#' ? directive_end(text, code) : declaration_end(text, code);
            const size_t word = skip_blanks(text, code + 1);
            if (text->bytes[code] != '#' || begins(text, word, "define"))
                find_name(text, &piece, code);
        }
        at = piece.end;
        if (!push(context, pieces, &piece))
            return 0;
    }
    return 1;
}

static int equal(const struct pieces *pieces, const struct piece *piece, const char *name,
                 size_t size)
{
    return piece->name_size == size && memcmp(pieces->text->bytes + piece->name, name, size) == 0;
}

static int lists(const tsu_model *model, const char *file)
{
    const char *const *own = model->snippets;
    while (*own && (!file || strcmp(*own, file) != 0))
        own++;
    return *own != NULL;
}

static const char *file_of(const struct tsu_i_assembly *out, unsigned source)
{
    return source > 0 && source < TSU_I_SOURCES && source < out->source_count ? out->sources[source]
                                                                              : NULL;
}

// Keep every piece called tsu_MODEL_WORD, tsu_MODEL_WORD_eval or, when it is a whole name, WORD.
static int keep_word(const struct pieces *pieces, const struct tsu_i_assembly *out,
                     const tsu_model *model, const char *word, size_t size)
{
    char bytes[192];
    int found = 0;
    for (int form = 0; form < 3; form++) {
        struct tsu_i_line name = {bytes, sizeof bytes, 0};
        if (form > 0) {
            tsu_i_line_put(&name, "tsu_");
            tsu_i_line_put(&name, model->info.name);
            tsu_i_line_put(&name, "_");
        }
        for (size_t i = 0; i < size; i++) {
            const char letter[2] = {word[i], 0};
            tsu_i_line_put(&name, letter);
        }
        if (form == 2)
            tsu_i_line_put(&name, "_eval");
        for (size_t i = 0; i < pieces->count; i++)
            if (equal(pieces, pieces->list + i, bytes, name.size) &&
                lists(model, file_of(out, pieces->list[i].source)))
                found = pieces->list[i].kept = 1;
    }
    return found;
}

size_t tsu_i_only_word(const char **list)
{
    while (**list == ',' || **list == ' ')
        ++*list;
    size_t size = 0;
    while ((*list)[size] && (*list)[size] != ',' && (*list)[size] != ' ')
        size++;
    return size;
}

static tsu_status keep_wanted(const tsu_context *context, const tsu_shader_desc *desc,
                              const struct tsu_i_assembly *out, struct pieces *pieces)
{
    // Files of a model of which nothing is named, and files of no model, stay whole.
    int whole[TSU_I_SOURCES];
    for (unsigned s = 0; s < TSU_I_SOURCES; s++) {
        whole[s] = 1;
        for (uint32_t m = 0; m < desc->model_count; m++)
            whole[s] = whole[s] && !lists(desc->models[m], file_of(out, s));
    }
    for (uint32_t m = 0; m < desc->model_count; m++) {
        int named = 0;
        const char *word = desc->only;
        for (size_t size; (size = tsu_i_only_word(&word)) > 0; word += size)
            named |= keep_word(pieces, out, desc->models[m], word, size);
        if (named)
            keep_word(pieces, out, desc->models[m], "sum", 3);
        for (unsigned s = 0; s < TSU_I_SOURCES && !named; s++)
            whole[s] = whole[s] || lists(desc->models[m], file_of(out, s));
    }
    const char *word = desc->only;
    for (size_t size; (size = tsu_i_only_word(&word)) > 0; word += size) {
        int found = 0;
        for (uint32_t m = 0; m < desc->model_count; m++)
            found |= keep_word(pieces, out, desc->models[m], word, size);
        if (!found) {
            char bytes[64];
            struct tsu_i_line line = {bytes, sizeof bytes, 0};
            for (size_t i = 0; i < size; i++) {
                const char letter[2] = {word[i], 0};
                tsu_i_line_put(&line, letter);
            }
            tsu_i_log(context, TSU_LOG_ERROR, TSU_LOG_SHADER,
                      "tsu_shader_desc.only: no model asked for has a function \"%s\"", bytes);
            return TSU_E_PARAMETER;
        }
    }
    for (size_t i = 0; i < pieces->count; i++) {
        struct piece *piece = pieces->list + i;
        piece->kept |= piece->code && (!piece->name_size || piece->source >= TSU_I_SOURCES ||
                                       whole[piece->source]);
    }
    return TSU_OK;
}

// What kept pieces name is kept, until nothing is added.
static void keep_needed(struct pieces *pieces)
{
    struct tsu_i_text *text = pieces->text;
    for (int more = 1; more;) {
        more = 0;
        for (size_t i = 0; i < pieces->count; i++) {
            struct piece *piece = pieces->list + i;
            if (piece->kept != 1)
                continue;
            piece->kept = 2; // its names have been seen to
            more = 1;
            size_t at = piece->begin;
            for (size_t size; (size = next_name(text, &at, piece->end)) > 0; at += size)
                for (size_t k = 0; k < pieces->count; k++)
                    if (!pieces->list[k].kept &&
                        equal(pieces, pieces->list + k, text->bytes + at, size))
                        pieces->list[k].kept = 1;
        }
    }
    // A comment alone, such as the head of a file, stays with what follows it in its file.
    int follows = 0;
    for (size_t i = pieces->count; i-- > 0;) {
        struct piece *piece = pieces->list + i;
        if (i + 1 < pieces->count && piece->source != piece[1].source)
            follows = 0;
        if (piece->code)
            follows |= piece->kept;
        else
            piece->kept = follows;
    }
}

tsu_status tsu_i_reach(const tsu_context *context, const tsu_shader_desc *desc,
                       struct tsu_i_assembly *out)
{
    struct pieces pieces = {.text = &out->text};
    tsu_status status = split(context, &pieces) ? TSU_OK : TSU_E_MEMORY;
    if (status == TSU_OK)
        status = keep_wanted(context, desc, out, &pieces);
    if (status == TSU_OK) {
        keep_needed(&pieces);
        struct tsu_i_rewrite rewrite = tsu_i_rewrite_begin(&out->text);
        int kept = 1;
        for (size_t i = 0; tsu_i_rewrite_line(&rewrite) > 0;) {
            // Empty lines go with the piece before them.
            while (i < pieces.count && rewrite.read >= pieces.list[i].begin)
                kept = pieces.list[i++].kept;
            const int moves = begins(&out->text, rewrite.read, "#line ");
            kept |= moves;
            tsu_i_rewrite_next(&rewrite, kept);
        }
        tsu_i_rewrite_end(&rewrite);
    }
    tsu_i_free(context, pieces.list, pieces.room, sizeof *pieces.list);
    return status;
}

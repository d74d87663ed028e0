// Text without a locale: numbers written by our own formatter, into fixed lines or growing buffers.
#ifndef TSU_BASE_TEXT_H
#define TSU_BASE_TEXT_H

#include <stdarg.h>
#include <stddef.h>

struct tsu_context;

// A fixed buffer, always zero-terminated; what does not fit is cut.
struct tsu_i_line {
    char *bytes;
    size_t capacity, size;
};
void tsu_i_line_put(struct tsu_i_line *line, const char *text);
void tsu_i_line_unsigned(struct tsu_i_line *line, unsigned long long value);
// Understands %s %d %u %g %%.
void tsu_i_line_format(struct tsu_i_line *line, const char *format, va_list arguments);

// A growing buffer, zero-terminated once anything was put. After a failed allocation `failed` is
// set and puts do nothing, so calls can be chained and checked once.
struct tsu_i_text {
    const struct tsu_context *context;
    char *bytes;
    size_t capacity, size;
    int failed;
};
void tsu_i_text_put(struct tsu_i_text *text, const char *bytes, size_t size);
void tsu_i_text_string(struct tsu_i_text *text, const char *string);
void tsu_i_text_number(struct tsu_i_text *text, unsigned value);
void tsu_i_text_free(struct tsu_i_text *text);

#endif

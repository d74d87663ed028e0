#include "base/text.h"

#include "base/host.h"

#include <math.h>
#include <string.h>

void tsu_i_line_put(struct tsu_i_line *line, const char *text)
{
    while (*text && line->size + 1 < line->capacity)
        line->bytes[line->size++] = *text++;
    line->bytes[line->size] = 0;
}

void tsu_i_line_unsigned(struct tsu_i_line *line, unsigned long long value)
{
    char digits[24];
    size_t n = sizeof digits - 1;
    digits[n] = 0;
    do
        digits[--n] = (char)('0' + value % 10);
    while (value /= 10);
    tsu_i_line_put(line, digits + n);
}

// Nine significant digits, trailing zeros dropped; exponents beyond 1e-5 .. 1e9.
static void put_double(struct tsu_i_line *line, double value)
{
    if (isnan(value)) {
        tsu_i_line_put(line, "nan");
        return;
    }
    if (value < 0) {
        tsu_i_line_put(line, "-");
        value = -value;
    }
    if (isinf(value)) {
        tsu_i_line_put(line, "inf");
        return;
    }
    int exponent = value > 0 ? (int)floor(log10(value)) : 0;
    const int fixed = exponent >= -5 && exponent < 9;
    const int places = 8 - exponent;
    // In two steps where one power of ten would leave the range of doubles.
    double scaled = fixed              ? value * pow(10, places)
                    : exponent < -300 ? value * 1e200 * pow(10, -192 - exponent)
                                      : value / pow(10, exponent) * 1e8;
    unsigned long long digits = (unsigned long long)(scaled + 0.5);
    if (!fixed && digits >= 1000000000u) { // rounded up to the next power of ten
        digits /= 10;
        exponent++;
    }
    int point = fixed ? places : 8; // digits after the point
    while (point > 0 && digits % 10 == 0) {
        digits /= 10;
        point--;
    }
    unsigned long long unit = 1;
    for (int i = 0; i < point; i++)
        unit *= 10;
    tsu_i_line_unsigned(line, digits / unit);
    if (point > 0) {
        tsu_i_line_put(line, ".");
        for (unsigned long long u = unit / 10; u > 0; u /= 10) {
            const char digit[2] = {(char)('0' + digits / u % 10), 0};
            tsu_i_line_put(line, digit);
        }
    }
    if (!fixed) {
        tsu_i_line_put(line, exponent < 0 ? "e-" : "e");
        tsu_i_line_unsigned(line, (unsigned long long)(exponent < 0 ? -exponent : exponent));
    }
}

void tsu_i_line_format(struct tsu_i_line *line, const char *format, va_list arguments)
{
    for (; *format; format++) {
        if (*format != '%') {
            const char one[2] = {*format, 0};
            tsu_i_line_put(line, one);
            continue;
        }
        switch (*++format) {
        case 's': {
            const char *string = va_arg(arguments, const char *);
            tsu_i_line_put(line, string ? string : "(null)");
            break;
        }
        case 'd': {
            const int value = va_arg(arguments, int);
            if (value < 0)
                tsu_i_line_put(line, "-");
            tsu_i_line_unsigned(line, value < 0 ? 0ull - (unsigned long long)value
                                         : (unsigned long long)value);
            break;
        }
        case 'u':
            tsu_i_line_unsigned(line, va_arg(arguments, unsigned));
            break;
        case 'g':
            put_double(line, va_arg(arguments, double));
            break;
        default:
            tsu_i_line_put(line, "%");
        }
    }
}

void tsu_i_text_put(struct tsu_i_text *text, const char *bytes, size_t size)
{
    if (text->failed)
        return;
    if (text->size + size + 1 > text->capacity) {
        const size_t capacity = 2 * text->capacity + size + 1024;
        char *grown = tsu_i_realloc(text->context, text->bytes, text->capacity, capacity, 1);
        if (!grown) {
            text->failed = 1;
            return;
        }
        text->bytes = grown;
        text->capacity = capacity;
    }
    memcpy(text->bytes + text->size, bytes, size);
    text->size += size;
    text->bytes[text->size] = 0;
}

void tsu_i_text_string(struct tsu_i_text *text, const char *string)
{
    tsu_i_text_put(text, string, strlen(string));
}

void tsu_i_text_number(struct tsu_i_text *text, unsigned value)
{
    char digits[16];
    struct tsu_i_line line = {digits, sizeof digits, 0};
    tsu_i_line_unsigned(&line, value);
    tsu_i_text_put(text, digits, line.size);
}

void tsu_i_text_free(struct tsu_i_text *text)
{
    tsu_i_free(text->context, text->bytes, text->capacity, 1);
    text->bytes = NULL;
    text->size = text->capacity = 0;
}

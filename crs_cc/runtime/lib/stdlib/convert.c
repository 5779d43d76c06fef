/* Doubles as digits (POSIX ecvt, fcvt, gcvt, long outdated). */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char digits[512];

/* Parses "d.ddde+xx": digits without point, position of the point, sign. */
static char *take_apart(const char *text, int count, int *point, int *negative)
{
    int size = 0;

    *negative = *text == '-';
    text += *negative;
    for (; *text && *text != 'e' && size < count; text++)
        if (*text != '.')
            digits[size++] = *text;
    digits[size] = 0;
    text = strchr(text, 'e');
    *point = text == NULL ? 0 : atoi(text + 1) + 1;
    return digits;
}

char *ecvt(double value, int count, int *point, int *negative)
{
    char text[400];

    if (count < 0)
        count = 0;
    if (count > 340)
        count = 340;
    sprintf(text, "%.*e", count > 0 ? count - 1 : 0, value);
    take_apart(text, count, point, negative);
    if (value == 0)
        *point = 1;
    return digits;
}

char *fcvt(double value, int count, int *point, int *negative)
{
    char text[800], *at = text;
    int size = 0;

    if (count < 0)
        count = 0;
    if (count > 190)
        count = 190;
    sprintf(text, "%.*f", count, value);
    *negative = *at == '-';
    at += *negative;
    *point = strcspn(at, ".");
    if (*at == '0') {
        *point = 0;
        at += 1 + (at[1] == '.');
        while (*at == '0' && value != 0) {
            at++;
            --*point;
        }
    }
    for (; *at; at++)
        if (*at != '.')
            digits[size++] = *at;
    digits[size] = 0;
    return digits;
}

char *gcvt(double value, int count, char *text)
{
    sprintf(text, "%.*g", count > 17 ? 17 : count, value);
    return text;
}

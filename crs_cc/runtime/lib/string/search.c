/* Searching in strings (C17 7.24.5; index, rindex, strsep, strtok_r: POSIX and BSD). */
#include <string.h>

char *strchr(const char *text, int c)
{
    for (; *text != (char)c; text++)
        if (*text == 0)
            return NULL;
    return (char *)text;
}

char *strrchr(const char *text, int c)
{
    const char *found = NULL;

    do {
        if (*text == (char)c)
            found = text;
    } while (*text++);
    return (char *)found;
}

char *index(const char *text, int c)
{
    return strchr(text, c);
}

char *rindex(const char *text, int c)
{
    return strrchr(text, c);
}

/* Counts the leading characters that are in the set, or that are not. */
static size_t span(const char *text, const char *set, int inside)
{
    unsigned char member[256];
    size_t length = 0;

    __builtin_memset(member, 0, sizeof member);
    while (*set)
        member[(unsigned char)*set++] = 1;
    while (text[length] && member[(unsigned char)text[length]] == inside)
        length++;
    return length;
}

size_t strspn(const char *text, const char *accept)
{
    return span(text, accept, 1);
}

size_t strcspn(const char *text, const char *reject)
{
    return span(text, reject, 0);
}

char *strpbrk(const char *text, const char *accept)
{
    text += span(text, accept, 0);
    return *text ? (char *)text : NULL;
}

char *strstr(const char *text, const char *part)
{
    size_t length = strlen(part);

    if (length == 0)
        return (char *)text;
    for (; (text = strchr(text, *part)) != NULL; text++)
        if (strncmp(text, part, length) == 0)
            return (char *)text;
    return NULL;
}

static char *next_token(char *text, const char *separators, char **rest)
{
    char *token;

    if (text == NULL)
        text = *rest;
    if (text == NULL)
        return NULL;
    token = text + span(text, separators, 1);
    text = token + span(token, separators, 0);
    if (*text)
        *text++ = 0;
    *rest = text;
    return token == text ? NULL : token;
}

char *strtok(char *text, const char *separators)
{
    static char *rest;

    return next_token(text, separators, &rest);
}

char *strtok_r(char *text, const char *separators, char **rest)
{
    return next_token(text, separators, rest);
}

char *strsep(char **text, const char *separators)
{
    char *token = *text;

    if (token != NULL) {
        char *end = token + span(token, separators, 0);
        *text = *end ? end + 1 : NULL;
        *end = 0;
    }
    return token;
}

int ffs(int value)
{
    return value == 0 ? 0 : __builtin_ctz(value) + 1;
}

/* Text handled through char pointers, in the manner of K&R. */
#include <stdio.h>

static int length(const char *s)
{
    const char *p = s;

    while (*p)
        p++;
    return p - s;
}

static char *copy(char *to, const char *from)
{
    char *start = to;

    while ((*to++ = *from++) != '\0')
        ;
    return start;
}

static int compare(const char *a, const char *b)
{
    for (; *a == *b; a++, b++)
        if (!*a)
            return 0;
    return *a - *b;
}

static void reverse(char *s)
{
    char *end = s + length(s) - 1, t;

    while (s < end) {
        t = *s;
        *s++ = *end;
        *end-- = t;
    }
}

static int count_words(const char *s)
{
    int words = 0, inside = 0;

    while (*s) {
        if (*s == ' ' || *s == '\t')
            inside = 0;
        else if (!inside)
            words++, inside = 1;
        s++;
    }
    return words;
}

static char *squeeze(char *s, char c)
{
    char *from = s, *to = s;

    do
        if (*from != c)
            *to++ = *from;
    while (*from++);
    return s;
}

int main(void)
{
    char buffer[40];

    printf("%d %d\n", length(""), length("sonar"));
    printf("%s\n", copy(buffer, "copied text"));
    reverse(buffer);
    printf("%s\n", buffer);
    printf("%d %d %d\n", compare("abc", "abc"), compare("abc", "abd"), compare("b", "abc"));
    printf("%d %d %d\n", count_words("  a few   words "), count_words(""), count_words("one"));
    printf("%s\n", squeeze(copy(buffer, "bananas"), 'a'));
    return 0;
}

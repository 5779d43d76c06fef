/* Strings and bytes beyond C: POSIX, BSD and GNU. */
#define _GNU_SOURCE
#include <libgen.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

static void show(const char *text)
{
    printf("[%s]", text == NULL ? "(none)" : text);
}

static void paths(void)
{
    static const char *const all[] = {
        "/usr/lib", "/usr/", "usr", "/", ".", "..", "", "a//b//", "/a", "a/b/c.txt",
    };
    char copy[32];
    size_t i;

    for (i = 0; i < sizeof all / sizeof *all; i++) {
        strcpy(copy, all[i]);
        show(dirname(copy));
        strcpy(copy, all[i]);
        show(basename(copy));
    }
    puts("");
}

int main(void)
{
    char text[40] = "a,b,,c", *rest = text, *token, buffer[16];

    while ((token = strsep(&rest, ",")) != NULL)
        show(token);
    strcpy(text, " one  two ");
    for (token = strtok_r(text, " ", &rest); token; token = strtok_r(NULL, " ", &rest))
        show(token);
    puts("");
    show(strcasestr("Hello World", "WORLD"));
    show(strcasestr("Hello", "lo!"));
    show(strcasestr("Hello", ""));
    show(strchrnul("key=value", '='));
    show(strchrnul("key", '='));
    show(memmem("haystack", 8, "sta", 3));
    show(memmem("haystack", 5, "sta", 3));
    show(memrchr("a.b.c", '.', 5));
    puts("");
    memset(buffer, '#', sizeof buffer);
    printf("%d %d\n", (int)(stpcpy(buffer, "abc") - buffer), buffer[4]);
    printf("%d %d %d\n", (int)(stpncpy(buffer, "xy", 5) - buffer), buffer[4], buffer[5]);
    printf("%d\n", (int)((char *)mempcpy(buffer, "12345", 5) - buffer));
    token = memccpy(buffer, "stop here", ' ', 9);
    printf("%d %d\n", (int)(token - buffer), memccpy(buffer, "none", 'x', 4) == NULL);
    printf("%d %d %d\n", strcasecmp("ABC", "abc"), strcasecmp("ABC", "abd") < 0,
           strncasecmp("ABCx", "abcy", 3));
    printf("%d %d %d %d\n", ffs(0), ffs(8), ffs(-2147483647 - 1), ffsll(1LL << 40));
    printf("%d %d\n", (int)strnlen("abc", 2), (int)strnlen("abc", 9));
    show(strndup("duplicate", 3));
    show(index("index", 'd'));
    show(rindex("rindex/x", 'x'));
    puts("");
    bcopy("abcdef", buffer, 7);
    bcopy(buffer, buffer + 2, 5);
    buffer[7] = 0;
    show(buffer);
    bzero(buffer, 3);
    printf("%d %d\n", buffer[2], bcmp("ab", "ab", 2));
    swab("badcfe", buffer, 6);
    printf("%.6s\n", buffer);
    paths();
    return 0;
}

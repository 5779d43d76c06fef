/* Escapes, concatenation, embedded zeros, continued lines. */
#include <stdio.h>
#include <string.h>

static const char *table[] = { "plain", "con" "cat" "enated", "tab\there", "\x41\x42" "C", "\101\1022",
    "quote\"quote'", "back\\slash", "a\
continued", "" };

int main(void)
{
    const char zeros[] = "ab\0cd\0";
    int i;
    const char *p = "\a\b\f\n\r\t\v\?";

    for (i = 0; i < 9; i++)
        printf("%s|%d\n", table[i], (int) strlen(table[i]));
    printf("%d %d %s\n", (int) sizeof zeros, (int) strlen(zeros), zeros + 3);
    while (*p)
        printf("%d ", *p++);
    printf("\n%d %d %d %d\n", '\'', '"', '\"', '\?');
    printf("%s%c%%%5s|%-5s|%.2s\n", "", '!', "ab", "cd", "efgh");
    printf("percent %d%% done\n", 50);
    printf("%d\n", "abc"[1] == 'b' && !"abc"[3]);
    printf("%d\n", (int) sizeof("12" "34"));
    puts("multi\n"
         "line");
    return 0;
}

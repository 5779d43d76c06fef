/* Adjacent strings are concatenated after their escapes are processed (C17 5.1.1.2). */
#include <stdio.h>
#include <string.h>

#define VERSION "1." "2"
#define QUOTE(x) #x

static const char joined[] = "one " "two " /* between */
    "three";
static const char hex[] = "\x41" "B", octal[] = "\1" "23", nothing[] = "" "";

int main(void)
{
    static const char *const list[] = { "a" "b", "c", "d" "" "e" };
    const char bytes[4] = "\0" "12";

    printf("%s %u\n", joined, (unsigned) sizeof joined);
    printf("%s %u\n", hex, (unsigned) sizeof hex);
    printf("%d %c %c %u\n", octal[0], octal[1], octal[2], (unsigned) sizeof octal);
    printf("%u\n", (unsigned) sizeof nothing);
    printf("version " VERSION " of " QUOTE(a b) "\n");
    printf("%s %s %s\n", list[0], list[1], list[2]);
    printf("%d%d%d%d\n", bytes[0], bytes[1], bytes[2], bytes[3]);
    printf("%" "d" "\n", (int) strlen("a\0b" "c"));
    printf("%s\n", "tab\tquote\"slash\\" "\x21\041\
\?");
    return 0;
}

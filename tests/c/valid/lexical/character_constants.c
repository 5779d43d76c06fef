/* Character constants have type int: escapes, multiple characters, signs. */
#include <stdio.h>

int main(void)
{
    char c = '\xff';

    printf("%d %d %d %d\n", 'a', '\n', '\0', '\\');
    printf("%d %d %d\n", '\a', '\b', '\v');
    printf("%d %d %d %d\n", '\101', '\12', '\7', '\x7F');
    printf("%d %d %d\n", '\'', '"', '\"');
    printf("%d %d\n", '\xff', '\377');
    printf("%d %d\n", c == '\xff', c == 0xff);
    printf("%d %d\n", 'ab' == ('a' << 8 | 'b'), 'abcd' == 0x61626364);
    printf("%u %u\n", (unsigned) sizeof 'a', (unsigned) sizeof L'a');
    printf("%d %d\n", (int) L'\x1234', (int) L'z');
    printf("%d\n", '9' - '0' + ('z' - 'a'));
    printf("%u %d\n", (unsigned) sizeof L"wide", (int) L"wide"[2]);
    switch ('b') {
    case 'a': printf("a\n"); break;
    case 'a' + 1: printf("b\n"); break;
    }
    return 0;
}

/* ctype.h over the ASCII characters. */
#include <stdio.h>
#include <ctype.h>

int main(void)
{
    int c, counts[11] = { 0 }, i;
    char text[] = "Nomad Scout II, 16 sonars!\n", *p;

    for (c = 0; c < 128; c++) {
        counts[0] += !!isalpha(c);
        counts[1] += !!isdigit(c);
        counts[2] += !!isalnum(c);
        counts[3] += !!isspace(c);
        counts[4] += !!isupper(c);
        counts[5] += !!islower(c);
        counts[6] += !!ispunct(c);
        counts[7] += !!isprint(c);
        counts[8] += !!iscntrl(c);
        counts[9] += !!isxdigit(c);
        counts[10] += !!isgraph(c);
    }
    for (i = 0; i < 11; i++)
        printf("%d ", counts[i]);
    printf("\n");
    for (p = text; *p; p++)
        *p = isupper(*p) ? tolower(*p) : islower(*p) ? toupper(*p) : isdigit(*p) ? '#' : *p;
    printf("%s", text);
    printf("%d %d %d\n", toupper('1'), tolower('Z'), isalpha(-1) ? 1 : 0);
    return 0;
}

/* Character arrays from string literals: exact, short, long, in structs. */
#include <stdio.h>
#include <string.h>

static char open_[] = "open";
static char exact[4] = "four";
static char longer[10] = "ten";
static char braced[] = { "braces" };
static char parts[] = "one" " " "two" "\0hidden";
static const char *pointer = "pointed", *tail = "tail" + 2;
static struct { char id[3]; char *text; char last; } s[] = { { "ab", "text", 'z' }, { { 'c' } } };
static unsigned char bytes[] = "\x01\xff\101";
static char grid[][6] = { "north", "east", "up" };

int main(void)
{
    char local[8] = "abc", modified[] = "change me";
    char empty[3] = "";
    int i, sum = 0;

    modified[0] = 'C';
    printf("%d %d %d %d %d\n", (int) sizeof open_, (int) sizeof exact, (int) sizeof longer,
           (int) sizeof braced, (int) sizeof parts);
    printf("%.4s %s %s %s %s\n", exact, longer, braced, parts, parts + 8);
    printf("%s %s %s\n", pointer, tail, modified);
    printf("%s %s %c %d %d\n", s[0].id, s[0].text, s[0].last, s[1].id[1], s[1].text == 0);
    printf("%d %d %d %d\n", bytes[0], bytes[1], bytes[2], (int) sizeof bytes);
    printf("%s %d %d\n", grid[1], (int) (sizeof grid / sizeof *grid), grid[2][5]);
    for (i = 0; i < 8; i++)
        sum += local[i];
    printf("%d %d\n", sum, empty[0] + empty[1] + empty[2]);
    for (i = 0; i < 10; i++)
        if (longer[i] == 0)
            break;
    printf("%d %d\n", i, (int) strlen(grid[0]));
    return 0;
}

/* sprintf and snprintf: lengths, truncation, building text piece by piece. */
#include <stdio.h>
#include <string.h>

static int append(char *to, int size, int at, const char *format, double v)
{
    int n = snprintf(to + at, at < size ? size - at : 0, format, v);
    return at + n;
}

int main(void)
{
    char small[8], line[64] = "";
    int n, i, at = 0;

    n = snprintf(small, sizeof small, "%d-%s", 1234, "abcdefgh");
    printf("%d %s\n", n, small);
    n = snprintf(small, 1, "xyz");
    printf("%d [%s]\n", n, small);
    n = snprintf(NULL, 0, "%08.3f", 3.14159);
    printf("%d\n", n);
    for (i = 0; i < 5; i++)
        at = append(line, sizeof line, at, i ? ", %.2f" : "%.2f", i / 3.0);
    printf("%d %s\n", at, line);
    n = sprintf(line, "%c%c", 'o', 'k');
    n += sprintf(line + n, "%5s|%-5s|", "r", "l");
    printf("%d %s\n", n, line);
    n = sprintf(line, "%s", "");
    printf("%d %d\n", n, (int) strlen(line));
    return 0;
}

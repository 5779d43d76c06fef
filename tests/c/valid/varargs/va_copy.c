/* va_copy, va_list handed to other functions, and started twice. */
#include <stdio.h>
#include <stdarg.h>
#include <string.h>

static int total_length(va_list ap)
{
    const char *s;
    int n = 0;

    while ((s = va_arg(ap, const char *)))
        n += strlen(s);
    return n;
}

static int join(char *to, int size, ...)
{
    va_list ap, copy;
    const char *s;

    va_start(ap, size);
    va_copy(copy, ap);
    if (total_length(copy) >= size) {
        va_end(copy);
        va_end(ap);
        return -1;
    }
    va_end(copy);
    *to = 0;
    while ((s = va_arg(ap, const char *)))
        strcat(to, s);
    va_end(ap);
    return strlen(to);
}

static int largest_twice(int n, ...)
{
    va_list ap;
    int i, best = 0, sum = 0;

    va_start(ap, n);
    for (i = 0; i < n; i++) {
        int v = va_arg(ap, int);
        best = v > best ? v : best;
    }
    va_end(ap);
    va_start(ap, n);
    for (i = 0; i < n; i++)
        sum += va_arg(ap, int) == best;
    va_end(ap);
    return best * 10 + sum;
}

static void take_two(va_list *ap)
{
    printf("%d ", va_arg(*ap, int));
    printf("%d ", va_arg(*ap, int));
}

static void by_pointer(int n, ...)
{
    va_list ap;

    va_start(ap, n);
    while (n -= 2, n >= 0)
        take_two(&ap);
    printf("| %g\n", va_arg(ap, double));
    va_end(ap);
}

int main(void)
{
    char buffer[20];

    printf("%d ", join(buffer, sizeof buffer, "one", "+", "two", (char *) 0));
    printf("%s\n", buffer);
    printf("%d\n", join(buffer, sizeof buffer, "much too long", " for the buffer", (char *) 0));
    printf("%d\n", largest_twice(5, 3, 9, 2, 9, 1));
    by_pointer(4, 1, 2, 3, 4, 5.5);
    return 0;
}

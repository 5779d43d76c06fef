/* A printf of one's own on top of vsnprintf, and one from scratch. */
#include <stdio.h>
#include <stdarg.h>

static int lines;

static int logf_(const char *level, const char *format, ...)
{
    char text[64];
    va_list ap;
    int n;

    va_start(ap, format);
    n = vsnprintf(text, sizeof text, format, ap);
    va_end(ap);
    printf("%d %s: %s\n", ++lines, level, text);
    return n;
}

static void put_number(unsigned n, unsigned base)
{
    if (n >= base)
        put_number(n / base, base);
    putchar("0123456789abcdef"[n % base]);
}

static void tiny_printf(const char *f, ...)
{
    va_list ap;
    int n;
    const char *s;

    va_start(ap, f);
    for (; *f; f++) {
        if (*f != '%') {
            putchar(*f);
            continue;
        }
        switch (*++f) {
        case 'd':
            n = va_arg(ap, int);
            if (n < 0)
                putchar('-');
            put_number(n < 0 ? -(unsigned) n : (unsigned) n, 10);
            break;
        case 'x': put_number(va_arg(ap, unsigned), 16); break;
        case 'c': putchar(va_arg(ap, int)); break;
        case 's': for (s = va_arg(ap, char *); *s; s++) putchar(*s); break;
        default: putchar(*f);
        }
    }
    va_end(ap);
}

int main(void)
{
    printf("%d\n", logf_("info", "robot %d at %.1f,%.1f", 3, 1.25, -7.75));
    printf("%d\n", logf_("warn", "%s %s %s %s", "a long line that does not", "fit into",
                         "sixty-three characters", "of buffer"));
    tiny_printf("%d %x %c %s %% %d\n", -2147483647 - 1, 0xbeef, 'q', "words", 0);
    return 0;
}

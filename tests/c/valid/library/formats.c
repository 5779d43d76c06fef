/* Rarely used features of printf and scanf. */
#define _GNU_SOURCE
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void prints(void)
{
    char *text;

    printf("%2$s %1$d|%1$5d|%3$.2f %2$s\n", 42, "numbered", 3.14159);
    printf("%2$*1$d|%3$lld %4$s|%5$.*1$f\n", 8, 5, 123456789012LL, "x", 0.5);
    errno = ENOENT;
    printf("%m|%10.3m|\n");
    printf("%" PRId64 " %" PRIu8 " %" PRIx32 " %" PRIXMAX " %" PRIdPTR "\n", INT64_MIN,
           (uint8_t)200, UINT32_C(0xbeef), UINTMAX_MAX, (intptr_t)-4);
    printf("%a %.3a %A %.0a %a\n", 1.0 / 3, 1.0, 255.5, 1.5, 5e-324);
    printf("%f %e %g %F %010f %-8f|\n", INFINITY, -INFINITY, NAN, -NAN, -INFINITY, NAN);
    printf("%5%|%-5d|%+i|% d|%#o|%#x|%#X|%hhd|%hd\n", 3, 4, 5, 8, 255, 255, 300, 70000);
    printf("%jd %zu %td %llx %#.3g %g %G\n", (intmax_t)-5, (size_t)7, (ptrdiff_t)-3,
           0xfedcba9876543210ULL, 1.0, 1e-5, 1e100);
    printf("%.30f %.20g\n", 0.1, 123456789.123456789);
    printf("%d", asprintf(&text, "%s-%d", "made", 5));
    printf(" %s\n", text);
    free(text);
    fflush(stdout);
    dprintf(1, "%s %c\n", "descriptor", 'd');
}

static void scans(void)
{
    char word[20] = "", set[20] = "", *made = NULL;
    int a = -1, b = -1, n = -1, count;
    unsigned char small = 0;
    double d = 0;
    float f = 0;
    long long big = 0;
    void *pointer = NULL;

    count = sscanf("12 abc 0x1F 3.5e2", "%d %s %i %lf%n", &a, word, &b, &d, &n);
    printf("%d: %d %s %d %g %d\n", count, a, word, b, d, n);
    count = sscanf("abc123-x]y", "%[a-c]%2d%*c%[]x-]", word, &a, set);
    printf("%d: %s %d %s\n", count, word, a, set);
    count = sscanf("key = value # note", "%[^= ] = %[^#]", word, set);
    printf("%d: %s|%s|\n", count, word, set);
    count = sscanf("300 99999999999 0xff", "%hhu %lld %p", &small, &big, &pointer);
    printf("%d: %d %lld %d\n", count, small, big, pointer == (void *)0xff);
    count = sscanf("allocated word", "%ms %d", &made, &a);
    printf("%d: %s\n", count, made);
    free(made);
    count = sscanf("many letters, here", "%m[a-z ]%1s", &made, word);
    printf("%d: %s %s\n", count, made, word);
    free(made);
    count = sscanf("inf -nan 0x1.8p3 1e", "%f %lf %lf", &f, &d, &d);
    printf("%d: %f %g\n", count, f, d);
    printf("%d %d %d %d\n", sscanf("", "%d", &a), sscanf("x", "%d", &a), sscanf("5", "%d %d", &a, &b),
           sscanf("  ", " "));
    printf("%d", sscanf("17%x", "%d%%%c", &a, word));
    printf(" %d %c\n", a, word[0]);
    count = sscanf("12345678901234567890 -1", "%d %u", &a, (unsigned int *)&b);
    printf("%d %d\n", count, b);
}

int main(void)
{
    prints();
    scans();
    return 0;
}

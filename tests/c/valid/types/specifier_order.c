/* Type specifiers, qualifiers and storage classes in any order (C17 6.7.2p2). */
#include <stdio.h>

int unsigned long a = 1;
long long unsigned int b = 2;
short signed int static c = -3;
char const unsigned d = 255;
int long extern e;
double long f = 4.5;
int typedef number;
const number static volatile g = 6;
enum { RED, GREEN } static colour = GREEN;
struct { int x; } const static point = { 7 };
unsigned inline static twice(unsigned n) { return 2 * n; }
long int e = 5;
signed h = -8;
unsigned const *i = (unsigned const *) &h;

int main(void)
{
    register unsigned j = 9;
    auto int k = 10;
    long const long l = 11;

    printf("%lu %llu %d %d %ld %g\n", a, b, c, d, e, (double) f);
    printf("%d %d %d %u %d\n", g, colour, point.x, twice(j), k);
    printf("%lld %d %u\n", l, h, *i);
    printf("%u %u %u %u\n", (unsigned) sizeof a, (unsigned) sizeof b, (unsigned) sizeof c,
           (unsigned) sizeof d);
    return 0;
}

/* Storage class last, empty declarations, old enum and struct habits, string writes. */
#include <stdio.h>

int static placed = 4;
long unsigned int strange = 5;
short register_count;
struct { int a; } unnamed_one;
struct forward *link;
struct forward { int n; };
typedef unsigned char byte;
byte flags[4] = "abc";
enum status { ok, failed, } state;
int (*handler)();
char *message();
;

char *
message(n)
{
    return n ? "failed" : "ok";
}

int volatile const reading = 9;

main(argc, argv)
    char **argv;
{
    struct forward f;
    int long wide = 3;
    double long precise = 2.5;

    unnamed_one.a = 1;
    link = &f;
    link->n = 17;
    handler = (int (*)()) message;
    state = failed;
    printf("%d %lu %d %d\n", placed, strange, register_count, unnamed_one.a);
    printf("%d %s %s\n", link->n, message(state), (char *) (*handler)(ok));
    printf("%d %d %ld %g\n", flags[1], reading, wide, (double) precise);
    return argc - 1;
}

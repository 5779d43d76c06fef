/* Calls that do not match the definition, but work on i386: extra, missing and odd arguments. */
#include <stdio.h>

int first_of();
int count_args();
int as_int();
unsigned as_unsigned();
char *as_text();
int variadic_like();

static int with_callback(f, n)
    int (*f)();
    int n;
{
    return f(n, n + 1, n + 2);
}

static int one(int a) { return a; }
static int two(int a, int b) { return a * 10 + b; }

int main()
{
    static char text[] = "pointer as int";
    int (*table[2])() = { one, (int (*)()) two };
    long address;

    printf("%d\n", first_of(7, 8, 9));
    printf("%d %d\n", with_callback(one, 5), with_callback(two, 5));
    printf("%d %d\n", table[0](3, 4), table[1](3, 4));
    address = as_int(text);
    printf("%s\n", (char *) address);
    printf("%s\n", as_text(address) + 8);
    printf("%u\n", as_unsigned(-1));
    printf("%d\n", variadic_like(2, 10, 20) + variadic_like(3, 1, 2, 3));
    return 0;
}

int first_of(a) int a; { return a; }
int as_int(p) char *p; { return (int) p; }
unsigned as_unsigned(u) unsigned u; { return u / 2; }
char *as_text(n) long n; { return (char *) n; }

int variadic_like(n, a, b, c)
    int n, a, b, c;
{
    return n == 2 ? a + b : a + b + c;
}

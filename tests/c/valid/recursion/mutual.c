/* Functions that call each other: even and odd, Hofstadter, a recursive descent parser. */
#include <stdio.h>

static int is_odd(unsigned n);
static int is_even(unsigned n) { return n == 0 ? 1 : is_odd(n - 1); }
static int is_odd(unsigned n) { return n == 0 ? 0 : is_even(n - 1); }

static int male(int n);
static int female(int n) { return n ? n - male(female(n - 1)) : 1; }
static int male(int n) { return n ? n - female(male(n - 1)) : 0; }

static const char *p;
static int sum(void);

static int atom(void)
{
    int n = 0;

    if (*p == '(') {
        p++;
        n = sum();
        p++;
        return n;
    }
    if (*p == '-') {
        p++;
        return -atom();
    }
    while (*p >= '0' && *p <= '9')
        n = n * 10 + *p++ - '0';
    return n;
}

static int product(void)
{
    int n = atom();

    while (*p == '*' || *p == '/')
        if (*p++ == '*')
            n *= atom();
        else
            n /= atom();
    return n;
}

static int sum(void)
{
    int n = product();

    while (*p == '+' || *p == '-')
        if (*p++ == '+')
            n += product();
        else
            n -= product();
    return n;
}

static int evaluate(const char *text)
{
    p = text;
    return sum();
}

int main(void)
{
    int i;

    printf("%d %d %d\n", is_even(50), is_odd(50), is_odd(77));
    for (i = 0; i < 15; i++)
        printf("%d%d ", female(i), male(i));
    printf("\n%d %d %d\n", evaluate("1+2*3"), evaluate("(1+2)*3-4/2"), evaluate("-(2+3)*-(4-10)"));
    printf("%d\n", evaluate("((((((((7))))))))*2*(3+(4*(5-(6-7))))"));
    return 0;
}

/* Factorial, Fibonacci, Ackermann, Hanoi, gcd, permutations. */
#include <stdio.h>

static unsigned long long factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }
static int fibonacci(int n) { return n < 2 ? n : fibonacci(n - 1) + fibonacci(n - 2); }
static int gcd(int a, int b) { return b ? gcd(b, a % b) : a; }

static int ackermann(int m, int n)
{
    if (m == 0)
        return n + 1;
    return ackermann(m - 1, n == 0 ? 1 : ackermann(m, n - 1));
}

static int moves;
static void hanoi(int n, char from, char to, char by)
{
    if (n == 0)
        return;
    hanoi(n - 1, from, by, to);
    if (moves++ < 7)
        printf("%c%c ", from, to);
    hanoi(n - 1, by, to, from);
}

static void permute(char *s, int from, int n)
{
    int i;
    char t;

    if (from == n) {
        printf("%s ", s);
        return;
    }
    for (i = from; i < n; i++) {
        t = s[from], s[from] = s[i], s[i] = t;
        permute(s, from + 1, n);
        t = s[from], s[from] = s[i], s[i] = t;
    }
}

static int power(int base, unsigned n)
{
    int half;

    if (n == 0)
        return 1;
    half = power(base, n / 2);
    return n % 2 ? half * half * base : half * half;
}

int main(void)
{
    char s[] = "abcd";

    printf("%llu %d %d\n", factorial(20), fibonacci(14), gcd(1071, 462));
    printf("%d %d\n", ackermann(2, 3), power(3, 19));
    hanoi(8, 'A', 'C', 'B');
    printf("%d\n", moves);
    permute(s, 0, 4);
    printf("\n");
    return 0;
}

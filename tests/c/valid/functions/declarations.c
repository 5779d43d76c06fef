/* Functions declared in blocks, several times, and before use. */
#include <stdio.h>

int twice(int);
int twice(int n);
static int local_helper(int);
extern double average(const int *v, int n), half(double);
int no_arguments();

int main(void)
{
    extern int later(int, int);
    int thrice(int);
    int v[] = { 1, 2, 4 };

    printf("%d %d\n", twice(4), thrice(4));
    printf("%g %g\n", average(v, 3), half(5));
    printf("%d %d\n", later(2, 3), local_helper(8));
    printf("%d\n", no_arguments());
    {
        int twice = 3;
        printf("%d\n", twice);
    }
    printf("%s\n", __func__);
    return 0;
}

int twice(int n) { return n * 2; }
int thrice(n) int n; { return n * 3; }
static int local_helper(int n) { return n - 1; }
double average(const int *v, int n)
{
    int i, sum = 0;
    for (i = 0; i < n; i++)
        sum += v[i];
    return half(sum * 2) / n;
}
double half(double x) { return x / 2; }
int later(int a, int b) { return a * 10 + b; }
int no_arguments() { return sizeof __func__; }

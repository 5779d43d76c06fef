/* Numeric methods: Newton's square root, bisection, Simpson's rule, Runge-Kutta. */
#include <stdio.h>

typedef double (*Function)(double);

static double cube_less_two(double x) { return x * x * x - 2; }
static double bell(double x) { return 1 / (1 + x * x); }

static double square_root(double a)
{
    double x = a > 1 ? a : 1, last;

    do {
        last = x;
        x = (x + a / x) / 2;
    } while (x < last);
    return last;
}

static double bisect(Function f, double low, double high)
{
    int i;

    for (i = 0; i < 60; i++) {
        double middle = (low + high) / 2;
        if ((f(low) < 0) == (f(middle) < 0))
            low = middle;
        else
            high = middle;
    }
    return low;
}

static double simpson(Function f, double a, double b, int n)
{
    double h = (b - a) / n, sum = f(a) + f(b);
    int i;

    for (i = 1; i < n; i++)
        sum += f(a + i * h) * (i % 2 ? 4 : 2);
    return sum * h / 3;
}

static double oscillator(double t_end, int steps)
{
    double x = 1, v = 0, h = t_end / steps;
    int i;

    for (i = 0; i < steps; i++) {
        double k1x = v, k1v = -x;
        double k2x = v + h / 2 * k1v, k2v = -(x + h / 2 * k1x);
        double k3x = v + h / 2 * k2v, k3v = -(x + h / 2 * k2x);
        double k4x = v + h * k3v, k4v = -(x + h * k3x);
        x += h / 6 * (k1x + 2 * k2x + 2 * k3x + k4x);
        v += h / 6 * (k1v + 2 * k2v + 2 * k3v + k4v);
    }
    return x;
}

int main(void)
{
    printf("%.15g %.15g %.15g\n", square_root(2), square_root(144), square_root(1e-10));
    printf("%.15g\n", bisect(cube_less_two, 0, 2));
    printf("%.12f\n", 4 * simpson(bell, 0, 1, 100));
    printf("%.12f\n", oscillator(3.14159265358979, 200));
    return 0;
}

/* Float arithmetic is rounded to float at each operation (SSE, as wasm does it). */
#include <stdio.h>

static float add(float a, float b) { return a + b; }

static float dot(const float *a, const float *b, int n)
{
    float sum = 0;
    int i;

    for (i = 0; i < n; i++)
        sum += a[i] * b[i];
    return sum;
}

int main(void)
{
    float a = 0.1f, b = 0.2f, big = 16777216.0f, sum = 0;
    float x[] = { 1.5f, -2.25f, 1e10f, 3e-5f }, y[] = { 0.1f, 0.7f, 1e-10f, 9e4f };
    int i;

    printf("%.9g %.9g %.9g %.9g\n", a + b, a * b, a - b, a / b);
    printf("%.9g\n", big + 1);
    printf("%.9g\n", big + 1.0);
    printf("%d %d\n", a == 0.1, a == 0.1f);
    for (i = 0; i < 100; i++)
        sum += 0.1f;
    printf("%.9g\n", sum);
    printf("%.9g\n", dot(x, y, 4));
    printf("%.9g\n", add(0.1, 0.2));
    printf("%.9g %.17g\n", a * 3, a * 3.0);
    printf("%g %g\n", 1e30f * 1e30f, 1e-30f * 1e-30f);
    a *= 1.1;
    printf("%.9g\n", a);
    a += 1;
    printf("%.9g\n", a++);
    printf("%.9g\n", -a);
    printf("%u %u\n", (unsigned) sizeof(a + 1), (unsigned) sizeof(a + 1.0));
    return 0;
}

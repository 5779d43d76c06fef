/* A vector of three, indexed by an enumeration of four. */
#include <stdio.h>
enum axis { X, Y, Z, W };
struct body { float speed[3]; float mass; };
static float total(const struct body *b, enum axis last)
{
    float sum = 0;
    int a;
    for (a = X; a <= last; a++)
        sum += b->speed[a]; // error: out of bounds
    return sum;
}
int main(void)
{
    struct body b = {{1, 2, 3}, 70};
    printf("%g\n", total(&b, PLANT(W, Z)));
    return 0;
}

/* malloc counts bytes. */
#include <stdlib.h>

static int *copy(const int *sonar, int count)
{
    int *values = malloc(count), i;

    for (i = 0; i < count; i++)
        values[i] = sonar[i]; // error: out of bounds
    return values;
}

int main(void)
{
    int sonar[16] = { 0 }, *values = copy(sonar, 16);

    free(values);
    return 0;
}

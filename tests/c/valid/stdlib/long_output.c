/* Output much longer than any buffer arrives complete and in order. */
#include <stdio.h>

int main(void)
{
    static char wide[700];
    int i;

    for (i = 0; i < 200; i++)
        printf("line %d of a long output, %s\n", i, i % 3 ? "" : "fizz");
    for (i = 0; i < 699; i++)
        wide[i] = 'a' + i % 26;
    printf("%s\n", wide);
    printf("[%300d] [%-300s]\n", 1, "left");
    return 0;
}

/* The bytes of a union's member, one too many. */
#include <stdio.h>
struct packet { union { unsigned int word; unsigned char byte[4]; } u; unsigned int check; };
int main(void)
{
    struct packet p;
    int i, sum = 0;
    p.u.word = 0x01020304;
    p.check = 99;
    for (i = 0; i <= PLANT(4, 3); i++)
        sum += p.u.byte[i]; // error: out of bounds
    printf("%d\n", sum);
    return 0;
}

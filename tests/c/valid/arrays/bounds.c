/* Array sizes from constant expressions, enums, sizeof and initialisers. */
#include <stdio.h>

enum { FRONT, LEFT, BACK, RIGHT, SIDES };
#define DEGREES 360
#define STEP 15

static int ring[DEGREES / STEP];
static char letters[] = { 'a', 'b', 'c' };
static int by_side[SIDES] = { [BACK] = 5 };
static double twice[2 * sizeof letters];
static int late[3] = { 7, 8, 9 };
static unsigned char page[1 << 6][sizeof(int)];

#define COUNT(a) ((int) (sizeof (a) / sizeof *(a)))

int main(void)
{
    int squares[] = { 0, 1, 4, 9, 16, 25 };
    char word[] = "seven";
    short sparse[] = { [9] = 1 };
    int i;

    printf("%d %d %d %d\n", COUNT(ring), COUNT(letters), COUNT(by_side), COUNT(twice));
    printf("%d %d %d\n", COUNT(squares), COUNT(word), COUNT(sparse));
    printf("%d %d\n", COUNT(late), COUNT(page));
    printf("%d %d %d\n", by_side[FRONT], by_side[BACK], late[2]);
    for (i = 0; i < COUNT(squares); i++)
        ring[squares[i] % COUNT(ring)] = i;
    for (i = 0; i < COUNT(ring); i++)
        printf("%d", ring[i]);
    printf("\n");
    return 0;
}

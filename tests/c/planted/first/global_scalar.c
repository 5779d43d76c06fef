/* A global gets the value of a variable that has none. */
#include <stdio.h>
static int last[2];
static void note(int *from) { last[1] = *from; }
int main(void)
{
    int reading;
    PLANT(, reading = 1);
    note(&reading);
    return last[1] > 5 ? 1 : 0; // error: uninitialised read
}

/* A part of a buffer is copied over itself. */
#include <stdio.h>
#include <string.h>
static unsigned char frame[32];
static void drop(int n) 
{
    if (PLANT(1, 0))
        memcpy(frame, frame + n, sizeof frame - n); // error: overlapping copy
    else
        memmove(frame, frame + n, sizeof frame - n);
}
int main(void)
{
    frame[5] = 9;
    drop(4);
    printf("%d\n", frame[1]);
    return 0;
}

/* Waits for another robot to come near, then says how near it is. */
#include <stdio.h>
#include <crs_uwb.h>

int main(void)
{
    int distance = uwb_wait_nearer(400);

    printf("a robot is %d.%d inches away\n", distance / 10, distance % 10);
    return 0;
}

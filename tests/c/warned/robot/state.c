/* Loops that wait for readings that nobody asks for, and readings in wrong units. */
#include <stdio.h>
#include <Nclient.h>

static int steps;

static void log_step(void)
{
    printf("%d\n", ++steps);
}

static void look(void)
{
    gs();
}

static void wait_in_vain(void)
{
    vm(100, 100, 0);
    while (State[STATE_SONAR_0] > 20) // warning: this loop waits for 'State' to change, but asks
    //     ^
        log_step();
    while (1) {
        printf("x\n");
        if (State[33]) // warning: this loop waits for 'State' to change
            break;
    }
    do {
        steps++;
    } while (!State[STATE_BUMPER] && steps < 1000); // warning: this loop waits for 'State'
}

static void wait_well(int sonar)
{
    int i;

    while (State[STATE_SONAR_0] > 20)
        gs();
    while (State[STATE_SONAR_0] > 20)
        look();
    for (i = 0; i < State[17]; i++)
        putchar('#');
    for (i = 17; i <= 32 && State[i] > 20; i++)
        putchar('.');
    while (State[sonar] > 20)
        sonar++;
    while (State[17] > 3)
        State[17]--;
}

static void compare(void)
{
    int front = State[17], i, other = State[18];

    if (State[STATE_SONAR_3] < 400) // warning: this comparison with 400 is always true: sonar
    //  ^
        st();
    for (i = 0; i < 16; i++)
        if (300 < State[STATE_SONAR_0 + i]) // warning: this comparison with 300 is always false
            st();
    if (front > 1000) // warning: always false: sonar readings are 0 to 255 inches
        st();
    if (State[STATE_IR_0] > 20) // warning: always false: infrared readings are 0 to 15
        st();
    if (State[STATE_CONF_STEER] < -900) // warning: always false: headings are 0 to 3599
        st();
    other *= 10;
    if (other > 400 || State[17] < 255 || State[34] > 4000 || State[17] >= 0)
        st();
}

int main(void)
{
    connect_robot(1, MODEL_SCOUT, "", 0);
    wait_in_vain();
    wait_well(17);
    compare();
    return 0;
}

/*
 * report_table2.c - the control program of Table 2 of the CRS report, in C.
 *
 * The report's excerpt was written for the body of a Java method of the first
 * simulator. Commands and structure are kept; what had to change, and why:
 *
 *   - it is a whole C program: headers, main(), braces that balance;
 *   - "String" is "char *", and connect_robot() takes what the vendor's does:
 *     robot, model, host, port (the report's section 2.2.1);
 *   - vm() sets both wheels, vm(right, left, 0); the excerpt gave one speed;
 *   - the excerpt drives on while it looks about. scout_pr() ends that, and
 *     st() before it lets the turns begin from a standstill;
 *   - a sonar that hears nothing reads 255 on a Scout, where the excerpt's read -1;
 *   - State[STATE_BUMPER] is a mask with one bit for each bumper, so that the
 *     approach ends when any is pressed, not only the first;
 *   - heatSensorCheck() and its condition on State[STATE_HEAT] are left out: the
 *     client library has no heat sensor yet;
 *   - what it does is printed.
 *
 * Usage:  crs run report_table2.c room.xml
 */

/*
 * This program will connect to a scout robot,
 * use commands for configuring and controlling movement,
 * and sensory information
 */

#include <stdio.h>
#include "Nclient.h"

#define NO_ECHO 255

int main(void)
{
    /* Connection */
    int ROBOT_ID = 1;
    int SERV_TCP_PORT = 7019;
    char *SERVER_MACHINE_NAME = "procyon.cis.ksu.edu";
    int turns = 0, moves = 0;

    if (!connect_robot(ROBOT_ID, MODEL_SCOUT, SERVER_MACHINE_NAME, SERV_TCP_PORT)) {
        printf("Connexion to robot failed\n");
        return 1;
    }

    dp(100, 100); /* Set the location of the robot as 100,100 */
    printf("at (%ld, %ld)\n", State[STATE_CONF_X], State[STATE_CONF_Y]);
    vm(10, 10, 0); /* Set the translational speed of the robot to 1 inch/sec */
    st();
    ws(1, 1, 0, 255);

    /* Robot turns until it is oriented towards any object sensed by the sonar */
    sonarSensorCheck();
    while (State[STATE_SONAR_1] == NO_ECHO) {
        scout_pr(1, 100);
        ws(1, 1, 0, 255);
        turns++;

        sonarSensorCheck();
    }
    printf("after %d turns an object at %ld inches\n", turns, State[STATE_SONAR_1]);

    /* Move towards the object sensed by the sonar */
    while (State[STATE_BUMPER] == 0) {
        pr(100, 100, 0);   /* Move forward 10 inches */
        ws(1, 1, 0, 255);  /* Wait for the completion of the move */
        get_bp();          /* get bumper readings into State */
        moves++;
    }
    printf("after %d moves a bump at (%ld, %ld)\n", moves,
           State[STATE_CONF_X], State[STATE_CONF_Y]);

    disconnect_robot(ROBOT_ID);
    return 0;
}

/*
 * This program will connect to a scout robot,
 * use commands for configuring and controlling movement,
 * and sensory information
 */

/* Connection */
int ROBOT_ID = 1;
int SERV_TCP_PORT = 7019;
String SERVER_MACHINE_NAME = "procyon.cis.ksu.edu";

if (!connect_robot(ROBOT_ID, SERV_TCP_PORT, SERVER_MACHINE_NAME)) {
    printf("Connexion to robot failed\n");
    return(1);
}

    dp(100,100); /* Set the location of the robot as 100,100 */
    vm(10);/* Set the translational speed of the robot to 1 inch/sec */

    heatSensorCheck(); /* Update the heat sensor reading in the State array */
    if (State[STATE_HEAT] == 1) {

        /* Robots turns until the it is oriented towards any object sensed by the sonar */
        sonarSensorCheck();
        while(State[STATE_SONAR_1] == -1) {
            scout_pr(1, 100);
            ws(1, 1, 0, 255);

            sonarSensorCheck();
        }

        /* Move towards the object sensed by the sonar*/
        while(State[STATE_BUMPER] != 1) {
            pr(100, 100, 0); // Move forward 10 inches
            ws(1, 1, 0, 255); // Wait for the completion of the move
            get_bp(); // get bumper readings into State
        }
    }
disconnect_robot(ROBOT_ID);
return(0);

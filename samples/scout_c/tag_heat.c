/*
 * tag_heat.c - finds hot objects and tags them, in the report's dialect.
 *
 * The robot drives in legs of ten inches. Before each leg it measures the heat: if there
 * is any, it prints it and tags, which cools everything in range. Then it checks three
 * front sonars, and turns towards the freer side while an obstacle is near. Several
 * robots can run it in one world: each tags what the others have left.
 *
 *     crs run tag_heat.c complex-3r.xml
 */

int LEGS = 40;          /* duration of the search */
int LEG = 100;          /* 0.1 inch */
int NEAR = 200;         /* 0.1 inch */
int TURN = 300;         /* 0.1 degree */

int tagged;             /* the heat removed */

/* Returns a sonar reading, a large one if there is no echo. */
int reading(int sonar)
{
    int tenths = State[STATE_SONAR_0 + sonar];

    return tenths == -1 ? 10000 : tenths;
}

int nearest(int a, int b, int c)
{
    int best = reading(a);

    if (reading(b) < best)
        best = reading(b);
    return reading(c) < best ? reading(c) : best;
}

void feel(int leg)
{
    int heat;

    heatSensorCheck();
    heat = State[STATE_HEAT];
    if (heat == 0)
        return;
    tagTarget();
    heatSensorCheck();
    tagged += heat - State[STATE_HEAT];
    printf("leg %d: heat %d at (%d, %d), %d after tagging\n", leg, heat,
           State[STATE_CONF_X] / 10, State[STATE_CONF_Y] / 10, State[STATE_HEAT]);
}

/* Turns until the way ahead is free. */
void look()
{
    int left, right, turns;

    sonarSensorCheck();
    left = nearest(1, 2, 3);
    right = nearest(15, 14, 13);
    for (turns = 0; turns < 12 && nearest(15, 0, 1) < NEAR; turns++) {
        scout_pr(0, left > right ? -TURN : TURN);       /* to the right is positive */
        ws(1, 1, 0, 255);
        sonarSensorCheck();
    }
}

void runcode()
{
    int leg;

    connect_robot(1, MODEL_SCOUT, "localhost", 8000);
    for (leg = 1; leg <= LEGS; leg++) {
        feel(leg);
        look();
        pr(LEG, LEG, 0);
        ws(1, 1, 0, 255);
        get_bp();
        if (State[STATE_BUMPER]) {              /* into an obstacle that no sonar detected */
            pr(-LEG, -LEG, 0);
            ws(1, 1, 0, 255);
        }
    }
    printf("%d of heat tagged\n", tagged);
    disconnect_robot(1);
}

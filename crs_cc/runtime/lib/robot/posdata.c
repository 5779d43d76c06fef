/* Where and when the sensors were read, and the time of the board that reads them. */
#include <string.h>

#include <crs/robot.h>

/* The data of replies so far; a Nomad's sensors are in this order. */
static struct {
    PosData infrared[INFRAREDS], sonar[SONARS], bumper, laser, compass;
} known;

/* Requests `count` readings of one kind of sensor, if they are attached to replies. */
static void fetch(int sensors, PosData *place, int count)
{
    struct __crs_message message;
    int taken = 0, page;

    if (!__crs_client.connected || __crs_client.left
        || (__crs_client.mask[SMASK_POS_DATA] & sensors) == 0)
        return;
    while (taken < count) {
        message.i[0] = sensors;
        message.i[1] = taken;
        message.size = 0;
        page = __crs_request(CRS_POS_DATA, &message);
        if (page <= 0)
            return;
        if (page > count - taken)
            page = count - taken;
        memcpy(place + taken, message.data, page * sizeof *place);
        taken += page;
    }
}

static int copy_ring(int sensors, PosData *place, PosData *ring)
{
    fetch(sensors, ring, 16);
    memcpy(place, ring, 16 * sizeof *ring);
    return TRUE;
}

static int copy_one(int sensors, PosData *place, PosData *ring, int size, int number)
{
    fetch(sensors, ring, size);
    if (number >= 0 && number < size)
        *place = ring[number];
    return TRUE;
}

/* The vendor's check of the argument is faulty and accepts any value; so does ours. */
int posDataRequest(int posRequest)
{
    Smask[SMASK_POS_DATA] = posRequest;
    __crs_use_mask();
    return TRUE;
}

int posDataCheck(void)
{
    return __crs_client.mask[SMASK_POS_DATA];
}

int posInfraredRingGet(PosData posData[INFRAREDS])
{
    return copy_ring(POS_INFRARED, posData, known.infrared);
}

int posInfraredGet(PosData *posData, int infraredNumber)
{
    return copy_one(POS_INFRARED, posData, known.infrared, INFRAREDS, infraredNumber);
}

int posSonarRingGet(PosData posData[SONARS])
{
    return copy_ring(POS_SONAR, posData, known.sonar);
}

int posSonarGet(PosData *posData, int sonarNumber)
{
    return copy_one(POS_SONAR, posData, known.sonar, SONARS, sonarNumber);
}

int posBumperGet(PosData *posData)
{
    return copy_one(POS_BUMPER, posData, &known.bumper, 1, 0);
}

int posLaserGet(PosData *posData)
{
    return copy_one(POS_LASER, posData, &known.laser, 1, 0);
}

int posCompassGet(PosData *posData)
{
    return copy_one(POS_COMPASS, posData, &known.compass, 1, 0);
}

int posTimeGet(void)
{
    return (int)__crs_client.board_ms;
}

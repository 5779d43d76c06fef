/* Battery voltages according to the last state: a reading of 0 to 255 means 2 to 5 volts
   after a divider (vendor source Nclient.c 2.7). */
#include <crs/robot.h>

static float voltage(unsigned char reading, double range)
{
    return (2.0 + reading * 3 / 255.0) * (range / 5.0);
}

float voltCpuGet(void)
{
    return voltage(__crs_client.cpu_battery, 12.0);
}

float voltMotorGet(void)
{
    return voltage(__crs_client.motor_battery, 12.85);
}

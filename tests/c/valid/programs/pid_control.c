/* PID control of a simulated motor, with wind-up limits, and a table of gains. */
#include <math.h>
#include <stdio.h>

struct pid {
    float kp, ki, kd;
    float integral, last_error, limit;
};

struct motor { double speed, load; };

static float clamp(float x, float limit) { return x > limit ? limit : x < -limit ? -limit : x; }

static float pid_step(struct pid *c, float error, float dt)
{
    float slope = (error - c->last_error) / dt;
    c->integral = clamp(c->integral + error * dt, c->limit / (c->ki != 0 ? c->ki : 1));
    c->last_error = error;
    return clamp(c->kp * error + c->ki * c->integral + c->kd * slope, c->limit);
}

static void motor_step(struct motor *m, double volts, double dt)
{
    m->speed += (volts * 4 - m->speed * 2 - m->load) * dt;
}

int main(void)
{
    static const struct pid table[] = {
        { .kp = 1, .limit = 12 },
        { .kp = 1, .ki = 2, .limit = 12 },
        { 3, 4, 0.05f, .limit = 12 },
    };

    for (int i = 0; i < (int) (sizeof table / sizeof table[0]); i++) {
        struct pid pid = table[i];
        struct motor motor = { 0, 0 };
        double highest = 0;
        int settled = -1;
        for (int tick = 0; tick < 400; tick++) {
            double target = tick < 200 ? 5 : -3;
            motor.load = tick > 120 && tick < 160 ? 6 : 0;
            motor_step(&motor, pid_step(&pid, (float) (target - motor.speed), 0.02f), 0.02);
            highest = fmax(highest, motor.speed);
            if (settled < 0 && fabs(motor.speed - target) < 0.05)
                settled = tick;
            if (tick % 80 == 79)
                printf("%7.3f", motor.speed);
        }
        printf("  highest %.3f, settled at %d\n", highest, settled);
    }
    return 0;
}

/* Arguments not converted for lack of a prototype, so the function reads half a double, or none. */
int vm();

int twice(value)
    float value;
{
    return (int) (2 * value);
}

int main(void)
{
    double speed = 10.0;

    vm(speed, speed, 0);  // warning: argument 1 is passed as a double, but 'vm' takes an integer
//  ^
    vm((int) speed, 10.0f, 0);  // warning: argument 2 is passed as a double
    twice(3);  // warning: 'twice' takes a double
    vm((char) speed, (short) speed, 0L);
    return twice(1.5f) - 3 + twice(speed) - 20;
}

/* A definition that does not agree with the prototype. */
static int turn(int degrees);
static int turn(double degrees) // error: conflicting
{
    return (int) degrees;
}

int main(void)
{
    return turn(3);
}

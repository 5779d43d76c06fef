/* A variable gets its value in one branch only. */
int main(int argc, char **argv)
{
    int speed;

    if (argc > 5)
        speed = 3;
    return speed + 1; // error: uninitialised read
}

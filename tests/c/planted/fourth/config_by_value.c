/* A configuration is passed by value through two functions, and kept in a global. */
#include <stdio.h>

struct config {
    double gain;
    int limit;
    char mode;
};

static struct config current;

static struct config checked(struct config config)
{
    if (config.gain > 10)
        config.gain = 10;
    return config;
}

static void use(struct config config)
{
    current = checked(config);
}

int main(void)
{
    struct config config;

    config.gain = 2.5;
    config.mode = 'a';
    PLANT(, config.limit = 4;)
    use(config);
    for (int i = 0; i < current.limit; i++) // error: uninitialised read
        putchar(current.mode);
    putchar('\n');
    return 0;
}

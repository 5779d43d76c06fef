/* Functions and variables that nothing uses. */
static int forgotten(void) // warning: static function 'forgotten' is never called
{
    return 1;
}

static int kept(void) __attribute__((unused));
static int kept(void)
{
    return 2;
}

static inline int small(void)
{
    return 3;
}

static int __attribute__((constructor)) first(void)
{
    return 4;
}

static int sized(void)
{
    return 5;
}

int main(int argc, char **argv)
{
    int left_over, also = 2; // warning: unused variable 'left_over'
    int measured, quiet __attribute__((unused)), assigned;
    char name[sizeof measured]; // warning: unused variable 'name'
    struct { int x; } outer;
    static int counter;

    assigned = 3;
    (void)outer;
    {
        int argc; // warning: unused variable 'argc'
    }
    return sizeof sized() + also - also;
}

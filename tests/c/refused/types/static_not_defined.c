/* A static function that is used must be defined in its file. */
static int helper(int n);

int main(void)
{
    return helper(1); // error: static function 'helper' is used, but defined nowhere
}

/* A case without switch. */
int main(void)
{
    case 1: return 0; // error: case
}
